#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "app/Faults.h"
#include "app/SmallDocuments.h"
#include "walkcycle/io/Image.h"

namespace walkcycle {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// A document that asks for files all over the computer and the network, as pictures and as other documents.
std::string hostile(const std::vector<std::string>& wishes) {
    std::string images, effects, materials, nodes;
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        const std::string n = std::to_string(i);
        images += "<image id=\"i" + n + "\"><init_from>" + wishes[i] + "</init_from></image>\n";
        effects += "<effect id=\"e" + n +
                   "\"><profile_COMMON><technique sid=\"c\"><lambert><diffuse><texture texture=\"i" + n +
                   "\" texcoord=\"UV\"/></diffuse></lambert></technique></profile_COMMON></effect>\n";
        materials += "<material id=\"m" + n + "\"><instance_effect url=\"#e" + n + "\"/></material>\n";
        nodes +=
            "<node><instance_node url=\"" + wishes[i] + "#n\"/><instance_geometry url=\"" + wishes[i] +
            "#g\"/><instance_geometry url=\"#triangle\"><bind_material><technique_common><instance_material "
            "symbol=\"m\" target=\"#m" +
            n + "\"/></technique_common></bind_material></instance_geometry></node>\n";
    }
    std::string text = liftedTriangle();
    text.replace(text.find("<triangles"), 10, "<triangles material=\"m\"");
    text.insert(text.find("<library_geometries>"),
                "<library_images>" + images + "</library_images><library_effects>" + effects +
                    "</library_effects><library_materials>" + materials + "</library_materials>");
    text.insert(text.find("<node id=\"lift\""), nodes);
    return text;
}

// Shown by the program's own system calls.
class SandboxTest : public testing::Test {
protected:
    SandboxTest() {
        namespace fs = std::filesystem;
        fs::create_directories(folder / "model/inside");
        fs::create_directories(folder / "outside");
        const Bytes png = encodePng({.width = 1, .height = 1, .hasAlpha = false, .rgba = {1, 2, 3, 255}});
        writeFile(folder / "model/inside/skin.png", png);
        writeFile(folder / "outside/secret.png", png);
        writeFile(folder / "outside/secret.dae", bytesOf(liftedTriangle()));
        fs::create_symlink("../outside", folder / "model/linked");
        fs::create_symlink("../outside/secret.png", folder / "model/innocent.png");
        fs::create_symlink("../outside/secret.dae", folder / "model/innocent.dae");
        fs::create_symlink("inside/skin.png", folder / "model/harmless.png");
        const std::string outside = folder / "outside/secret";
        std::vector<std::string> wishes = {"inside/skin.png", "harmless.png"};
        for (const std::string ending : {".png", ".dae"})
            for (const std::string& wish :
                 {"../outside/secret" + ending, "inside/../../outside/secret" + ending, outside + ending,
                  "file://" + outside + ending, "file://localhost" + outside + ending,
                  "..%2Foutside%2Fsecret" + ending, "%2e%2e/outside/secret" + ending,
                  "..\\outside\\secret" + ending, "linked/secret" + ending, "innocent" + ending,
                  "http://127.0.0.1:9/secret" + ending, "https://example.com/secret" + ending,
                  "ftp://example.com/secret" + ending, "//127.0.0.1/share/secret" + ending})
                wishes.push_back(wish);
        for (const char* wish : {"../../../../../../../../etc/passwd", "/etc/passwd", "file:///etc/passwd",
                                 "/proc/version", "/dev/zero"})
            wishes.push_back(wish);
        writeFile(document, bytesOf(hostile(wishes)));
    }

    std::string callsOf(std::vector<std::string> arguments) {
        const auto logged =
            strace(folder / "log", {"-e", "trace=open,openat,openat2,creat,socket,connect,execve"});
        const Ran ran = runWalkcycle(arguments, "", traced(), logged);
        EXPECT_EQ(ran.exitCode, arguments.front() == "check" ? 1 : 0) << ran.err;
        return textOf(folder / "log");
    }

    TestFolder folder;
    std::string document = folder / "model/hostile.dae";
};

TEST_F(SandboxTest, nothingOutsideTheDocumentsFolderIsOpenedAndNoNetworkUsed) {
    if (!canTrace()) GTEST_SKIP() << "strace is not installed, or may not trace";
    for (const char* verb : {"info", "check", "pose"}) {
        const std::string calls = callsOf({verb, document});
        EXPECT_THAT(calls, HasSubstr("hostile.dae\"")) << "the log tells nothing";
        EXPECT_THAT(calls, HasSubstr("skin.png\"")) << "the log tells nothing";
        for (const char* never : {"secret", "innocent", "linked/", "/etc/passwd", "/proc/version",
                                  "/dev/zero", "AF_INET", "connect("})
            EXPECT_THAT(calls, Not(HasSubstr(never))) << verb;
    }
}

TEST_F(SandboxTest, aFolderThatIsAllowedIsOpenedAndNoOther) {
    if (!canTrace()) GTEST_SKIP() << "strace is not installed, or may not trace";
    const std::string calls = callsOf({"info", document, "--allow-path", folder / "outside"});
    EXPECT_THAT(calls, AllOf(HasSubstr("secret.png\""), HasSubstr("secret.dae\"")));
    for (const char* never : {"/etc/passwd", "/proc/version", "/dev/zero", "AF_INET"})
        EXPECT_THAT(calls, Not(HasSubstr(never)));
}

}  // namespace
}  // namespace walkcycle
