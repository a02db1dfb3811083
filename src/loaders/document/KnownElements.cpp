#include "loaders/document/KnownElements.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include <tinyxml2.h>

#include "loaders/text/Spelling.h"
#include "loaders/text/Words.h"

namespace walkcycle {
namespace {

struct Row {
    const char* element;
    const char* children;  // "!" after a name: at most one
};

// The children of all shading models together: exporters write them in any model, and EffectReader reads them in any.
constexpr const char* kShaderChildren =
    "emission! ambient! diffuse! specular! shininess! reflective! reflectivity! transparent! transparency! "
    "index_of_refraction! extra";

// The children that COLLADA 1.4.1 and 1.5.0 allow in the elements that are read. (<extra> is also allowed where the schema
// forbids it, since exporters put it there.)
constexpr Row kRows[] = {
    {"COLLADA",
     "asset! scene! extra library_animations library_animation_clips library_articulated_systems "
     "library_cameras "
     "library_controllers library_effects library_force_fields library_formulas library_geometries "
     "library_images "
     "library_joints library_kinematics_models library_kinematics_scenes library_lights library_materials "
     "library_nodes library_physics_materials library_physics_models library_physics_scenes "
     "library_visual_scenes"},
    {"asset", "contributor coverage created keywords modified revision subject title unit! up_axis! extra"},
    {"contributor", "author author_email author_website authoring_tool! comments copyright source_data"},
    {"scene", "instance_visual_scene! instance_physics_scene instance_kinematics_scene extra"},

    {"library_animations", "asset animation extra"},
    {"animation", "asset animation source sampler channel extra"},
    {"sampler", "input extra"},
    {"channel", "extra"},
    {"library_animation_clips", "asset animation_clip extra"},
    {"animation_clip", "asset instance_animation instance_formula extra"},

    {"library_cameras", "asset camera extra"},
    {"camera", "asset optics! imager extra"},
    {"optics", "technique_common! technique extra"},
    {"optics/technique_common", "perspective orthographic extra"},
    {"perspective", "xfov! yfov! aspect_ratio! znear! zfar! extra"},
    {"orthographic", "xmag! ymag! aspect_ratio! znear! zfar! extra"},
    {"library_lights", "asset light extra"},
    {"light", "asset technique_common! technique extra"},
    {"light/technique_common", "ambient directional point spot extra"},
    {"ambient light", "color! extra"},
    {"directional", "color! extra"},
    {"point", "color! constant_attenuation! linear_attenuation! quadratic_attenuation! extra"},
    {"spot",
     "color! constant_attenuation! linear_attenuation! quadratic_attenuation! falloff_angle! "
     "falloff_exponent! "
     "extra"},

    {"library_geometries", "asset geometry extra"},
    {"geometry", "asset mesh! convex_mesh! spline brep extra"},
    {"mesh", "source vertices! lines linestrips polygons polylist triangles trifans tristrips extra"},
    {"convex_mesh", "source vertices! lines linestrips polygons polylist triangles trifans tristrips extra"},
    {"vertices", "input extra"},
    {"triangles", "input p extra"},
    {"lines", "input p extra"},
    {"linestrips", "input p extra"},
    {"trifans", "input p extra"},
    {"tristrips", "input p extra"},
    {"polygons", "input p ph extra"},
    {"ph", "p! h"},
    {"polylist", "input vcount! p extra"},
    {"source",
     "asset bool_array float_array int_array Name_array IDREF_array SIDREF_array token_array "
     "technique_common! "
     "technique extra"},
    {"source/technique_common", "accessor! extra"},
    {"accessor", "param extra"},
    {"float_array", ""},
    {"int_array", ""},
    {"Name_array", ""},
    {"IDREF_array", ""},
    {"p", ""},
    {"h", ""},
    {"v", ""},
    {"vcount", ""},

    {"library_controllers", "asset controller extra"},
    {"controller", "asset skin! morph! extra"},
    {"skin", "bind_shape_matrix! source joints! vertex_weights! extra"},
    {"joints", "input extra"},
    {"vertex_weights", "input vcount! v! extra"},
    {"morph", "source targets! extra"},
    {"targets", "input extra"},

    {"library_nodes", "asset node extra"},
    {"library_visual_scenes", "asset visual_scene extra"},
    {"visual_scene", "asset node evaluate_scene extra"},
    {"node",
     "asset lookat matrix rotate scale skew translate instance_camera instance_controller instance_geometry "
     "instance_light instance_node node extra"},
    {"matrix", ""},
    {"translate", ""},
    {"rotate", ""},
    {"scale", ""},
    {"lookat", ""},
    {"skew", ""},
    {"instance_geometry", "bind_material! extra"},
    {"instance_controller", "skeleton bind_material! extra"},
    {"bind_material", "param technique_common! technique extra"},
    {"bind_material/technique_common", "instance_material extra"},
    {"instance_material", "bind bind_vertex_input extra"},

    {"library_materials", "asset material extra"},
    {"material", "asset instance_effect! extra"},
    {"instance_effect", "technique_hint setparam extra"},
    {"library_effects", "asset effect extra"},
    {"effect",
     "asset annotate image newparam profile_BRIDGE profile_CG profile_GLES profile_GLES2 profile_GLSL "
     "profile_COMMON extra"},
    {"profile_COMMON", "asset image newparam technique! extra"},
    {"profile_COMMON/technique", "asset image newparam constant! lambert! phong! blinn! extra"},
    {"constant", kShaderChildren},
    {"lambert", kShaderChildren},
    {"phong", kShaderChildren},
    {"blinn", kShaderChildren},
    {"emission", "color! param! texture! extra"},
    {"ambient", "color! param! texture! extra"},
    {"diffuse", "color! param! texture! extra"},
    {"specular", "color! param! texture! extra"},
    {"reflective", "color! param! texture! extra"},
    {"transparent", "color! param! texture! extra"},
    {"shininess", "float! param! extra"},
    {"reflectivity", "float! param! extra"},
    {"transparency", "float! param! extra"},
    {"index_of_refraction", "float! param! extra"},
    {"texture", "extra"},
    {"profile_COMMON/newparam",
     "annotate semantic modifier float float2 float3 float4 surface sampler2D sampler1D sampler3D "
     "samplerCUBE "
     "samplerRECT samplerDEPTH samplerStates"},
    {"library_images", "asset image extra"},
    {"image", "asset data! init_from! renderable create_2d create_3d create_cube extra"},
};

constexpr int kMostExplained = 1000;  // unknown elements; more are only counted

struct Known {
    std::string_view name;
    bool once;
};
using Children = std::vector<Known>;

// The children by their parent's name. A name that is used for several elements has its own parent's in front.
const std::unordered_map<std::string_view, Children>& schema() {
    static const auto made = [] {
        std::unordered_map<std::string_view, Children> childrenByElement;
        for (const Row& row : kRows)
            for (Children& children = childrenByElement[row.element];
                 std::string_view word : splitWords(row.children)) {
                const bool once = word.ends_with('!');
                if (once) word.remove_suffix(1);
                children.push_back({word, once});
            }
        return childrenByElement;
    }();
    return made;
}

const Children* childrenOf(XmlNode element) {
    const std::string_view name = element.name();
    std::string qualified;
    if (name == "technique_common" || name == "technique" || name == "newparam")
        qualified = std::string(element.parent().name()) + "/" + std::string(name);
    if (name == "ambient" && element.parent().is("technique_common")) qualified = "ambient light";
    const auto found = schema().find(qualified.empty() ? name : std::string_view(qualified));
    return found == schema().end() ? nullptr : &found->second;
}

bool isKnownElsewhere(std::string_view name) {
    return std::any_of(schema().begin(), schema().end(), [&](const auto& entry) {
        return std::any_of(entry.second.begin(), entry.second.end(),
                           [&](const Known& known) { return known.name == name; });
    });
}

// The namespace prefix of an element's name: "c:" in <c:COLLADA xmlns:c="...">.
std::string_view prefixOf(XmlNode element) {
    const std::string_view qualified = element.element()->Name();
    return qualified.substr(0, qualified.size() - element.name().size());
}

class Checker {
public:
    Checker(XmlNode collada, Diagnostics& diagnostics)
        : prefix_(prefixOf(collada)), diagnostics_(diagnostics) {}

    void run(XmlNode collada) {
        const XmlNode::Descendants elements = collada.descendants();
        if (!enter(collada)) return;
        for (auto element = elements.begin(); element != elements.end(); ++element) {
            levels_.resize(static_cast<std::size_t>(element.depth()));
            const bool foreign = element->has("xmlns") || prefixOf(*element) != prefix_;
            if (foreign || !isAllowed(*element, levels_.back()) || !enter(*element)) element.skipChildren();
        }
    }

private:
    struct Level {
        XmlNode parent;
        const Children* children = nullptr;
        std::uint64_t seen = 0;  // a bit for each child that is allowed once
    };

    // Returns false if the element may have any children, or has none.
    bool enter(XmlNode element) {
        const Children* children = element.firstChild() ? childrenOf(element) : nullptr;
        if (children) levels_.push_back({element, children});
        return children != nullptr;
    }

    bool isAllowed(XmlNode child, Level& level) {
        const Children& children = *level.children;
        const std::string_view name = child.name();
        const auto known =
            std::find_if(children.begin(), children.end(), [&](const Known& k) { return k.name == name; });
        if (known == children.end()) {
            reportUnknown(child, level);
            return false;
        }
        if (!known->once) return true;
        const std::uint64_t bit = std::uint64_t{1} << (known - children.begin());
        const bool isFirst = !(level.seen & bit);
        level.seen |= bit;
        if (!isFirst)
            diagnostics_.report(Code::ElementRepeated, child,
                                {std::string(name), std::string(level.parent.name())});
        return isFirst;
    }

    // A warning if the element is misspelt or in a wrong place, since its content is lost. An info if the format does not
    // have the name at all: then it is mostly an exporter's own addition.
    void reportUnknown(XmlNode child, const Level& level) {
        if (++unknown_ > kMostExplained)
            return diagnostics_.report(Code::ElementUnknown, child, {});  // only counted
        std::string names;
        for (const Known& known : *level.children) names.append(known.name).append(" ");
        const std::string meant(nearest(child.name(), names));
        const bool isSlip = !meant.empty() || isKnownElsewhere(child.name());
        diagnostics_.report(isSlip ? Severity::Warning : Severity::Info, Code::ElementUnknown, child,
                            {std::string(child.name()), std::string(level.parent.name()),
                             meant.empty() ? "" : "; perhaps <" + meant + "> is meant"});
    }

    std::string_view prefix_;
    Diagnostics& diagnostics_;
    std::vector<Level> levels_;  // the ancestors of the current element
    int unknown_ = 0;
};

}  // namespace

void checkElements(XmlNode collada, Diagnostics& diagnostics) {
    Checker(collada, diagnostics).run(collada);
}

}  // namespace walkcycle
