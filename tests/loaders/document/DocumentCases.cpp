#include <string>
#include <vector>

#include "loaders/CodeCases.h"
#include "loaders/TestFiles.h"

namespace walkcycle {
namespace {

const std::string kNamespace = "xmlns='http://www.collada.org/2005/11/COLLADASchema'";

std::string rootWith(const std::string& attributes) {
    return "<?xml version='1.0'?>\n@<COLLADA " + attributes + ">\n" + scene("<node id='n'/>") + "</COLLADA>";
}

// The 98th element is one too many for tinyxml2.
std::string nested() {
    std::string text = "<COLLADA version='1.4.1'>\n";
    for (int depth = 2; depth < 120; ++depth) text += std::string(depth == 99 ? "@" : "") + "<node>\n";
    return text + "</COLLADA>";
}

// An archive of two documents that does not say which is meant.
std::string twoInOne() {
    const std::string document = collada(scene("<node id='n'/>"));
    const Bytes archive = zipOf({{"a.dae", document}, {"b.dae", document}});
    return "@" + std::string(archive.begin(), archive.end());
}

}  // namespace

std::vector<CodeCase> documentCases() {
    return {
        {Code::NotXml, "<COLLADA version='1.4.1'>\n@<asset>\n</scene>\n</COLLADA>", ""},
        {Code::BadEncoding, std::string("<COLLADA version='1.4.1'>\n@<asset") + '\0' + "/></COLLADA>", ""},
        {Code::TooDeep, nested(), ""},
        {Code::NotCollada, "<?xml version='1.0'?>\n@<html/>", "html"},
        {Code::UnknownVersion, rootWith("version='1.7' " + kNamespace), "COLLADA"},
        {Code::WrongNamespace, rootWith("version='1.4.1' xmlns='http://example.org/'"), "COLLADA"},
        {Code::DuplicateId, collada(scene("<node id='hip'/>\n@<node id='hip'/>")),
         "COLLADA/library_visual_scenes/visual_scene[id=scene]/node[id=hip]"},
        {Code::ArchiveBroken, "@PK\x03\x04 and no archive", ""},
        {Code::BadAsset,
         "<COLLADA version='1.4.1'>\n<asset>\n@<unit meter='0'/>\n</asset>\n" + scene("<node id='n'/>") +
             "</COLLADA>",
         "COLLADA/asset/unit"},
        {Code::Version13, rootWith("version='1.3.0'"), "COLLADA"},
        {Code::EntitiesRefused,
         "<?xml version='1.0'?>\n<!DOCTYPE COLLADA [\n@<!ENTITY lol 'lol'>\n]>\n<COLLADA/>", ""},
        {Code::EncodingGuessed, collada(scene("<node id='n'/>\n@<node id='h\xFCpfer'/>")), ""},
        {Code::ControlCharacter, collada(scene("<node id='n'/>\n@<node id='a\x01'/>")), ""},
        {Code::RootGuessed, twoInOne(), ""},
        {Code::QuirkFollowed,
         collada(scene("<node id='n'><extra><technique profile='FCOLLADA'>\n@<visibility>0</visibility>"
                       "</technique></extra></node>")),
         "COLLADA/library_visual_scenes/visual_scene[id=scene]/node[id=n]/extra/technique/visibility"},
    };
}

}  // namespace walkcycle
