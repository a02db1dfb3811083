#pragma once

#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "walkcycle/model/Diagnostic.h"
#include "walkcycle/profiles/Profile.h"

// A document that every target takes as it is, changed in one place per test.
namespace walkcycle {

struct Change {
    std::string from, to;  // the first `from` is replaced; a test failure where there is none
};

std::string cleanDocument();  // tests/fixtures/profile-clean.dae
std::string changed(const std::vector<Change>& changes);

// Pieces to put in.
std::string imageEffect(
    const std::string& slots);                  // replaces the effect's <lambert>: with a picture in map.png
std::string inScene(const std::string& nodes);  // more nodes at the scene's end: the `to` of {kSceneEnd, ...}
inline const std::string kSceneEnd = "    </visual_scene>";
inline const std::string kLambert =
    "          <lambert>\n            <diffuse>\n              <color>0.8 0.5 0.2 1</color>\n"
    "            </diffuse>\n          </lambert>\n";

// What a profile says, WC10xx alone.
std::vector<Diagnostic> said(Profile profile, const std::string& text);

// That it says this once (and counts no more of it), about the element in the line where `marker` first stands, whose
// path ends so.
void expectSaid(Profile profile, const std::string& text, const std::string& code, const std::string& marker,
                const std::string& pathEnd);

}  // namespace walkcycle
