#pragma once

#include <string>

namespace walkcycle {

// A triangle with corners at 0, 1 in x and 1 in y, whose node "lift" moves from y = 0 at 0 s to y = 2 at 1 s and
// back at 2 s. Two clips: "up" and "down". A camera "front" looks at it.
inline std::string liftedTriangle(const std::string& material = "") {
    return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Y_UP</up_axis></asset>
<library_cameras><camera id="lens"><optics><technique_common>
<perspective><yfov>45</yfov><aspect_ratio>1</aspect_ratio><znear>0.1</znear><zfar>100</zfar></perspective>
</technique_common></optics></camera></library_cameras>
<library_geometries><geometry id="triangle"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 0 1 0 9 9 9</float_array><technique_common>
<accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="scene">
<node id="lift" name="Lift"><translate sid="t">0 0 0</translate><instance_geometry url="#triangle">)" +
           material + R"(</instance_geometry></node>
<node id="front"><translate>0.3 0.5 6</translate><instance_camera url="#lens"/></node>
</visual_scene></library_visual_scenes>
<library_animations><animation id="a">
<source id="i"><float_array id="ia" count="3">0 1 2</float_array><technique_common>
<accessor source="#ia" count="3" stride="1"><param name="TIME" type="float"/></accessor></technique_common></source>
<source id="o"><float_array id="oa" count="3">0 2 0</float_array><technique_common>
<accessor source="#oa" count="3" stride="1"><param name="Y" type="float"/></accessor></technique_common></source>
<source id="n"><Name_array id="na" count="3">LINEAR LINEAR LINEAR</Name_array><technique_common>
<accessor source="#na" count="3" stride="1"><param name="INTERPOLATION" type="name"/></accessor></technique_common></source>
<sampler id="s"><input semantic="INPUT" source="#i"/><input semantic="OUTPUT" source="#o"/>
<input semantic="INTERPOLATION" source="#n"/></sampler>
<channel source="#s" target="lift/t.Y"/></animation></library_animations>
<library_animation_clips>
<animation_clip id="up" name="up" start="0" end="1"><instance_animation url="#a"/></animation_clip>
<animation_clip id="down" name="down" start="1" end="2"><instance_animation url="#a"/></animation_clip>
</library_animation_clips>
<scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
)";
}

// The same with a face whose index is outside its source, in line 12.
inline std::string damagedTriangle() {
    std::string text = liftedTriangle();
    return text.replace(text.find("<p>0 1 2</p>"), 12, "<p>0 1 7</p>");
}

// The same with a material that is not there: drawn, with a warning.
inline std::string unpaintedTriangle() {
    std::string text =
        liftedTriangle(R"(<bind_material><technique_common><instance_material symbol="m" target="#gone"/>
</technique_common></bind_material>)");
    return text.replace(text.find("<triangles"), 10, "<triangles material=\"m\"");
}

}  // namespace walkcycle
