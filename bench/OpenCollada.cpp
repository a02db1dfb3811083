// OpenCOLLADA reads a file and hands its parts to a writer; this one throws them away, so that what is measured is the
// reading alone. (Nothing is joined, triangulated or fitted: there is no model at the end.)

#include <stdexcept>
#include <string>

#include <COLLADAFWIWriter.h>
#include <COLLADAFWRoot.h>
#include <COLLADASaxFWLLoader.h>

void loadWithOpenCollada(const std::string& file);

namespace {

class Nobody : public COLLADAFW::IWriter {
public:
    void cancel(const COLLADAFW::String&) override {}
    void start() override {}
    void finish() override {}
    bool writeGlobalAsset(const COLLADAFW::FileInfo*) override { return true; }
    bool writeScene(const COLLADAFW::Scene*) override { return true; }
    bool writeVisualScene(const COLLADAFW::VisualScene*) override { return true; }
    bool writeLibraryNodes(const COLLADAFW::LibraryNodes*) override { return true; }
    bool writeGeometry(const COLLADAFW::Geometry*) override { return true; }
    bool writeMaterial(const COLLADAFW::Material*) override { return true; }
    bool writeEffect(const COLLADAFW::Effect*) override { return true; }
    bool writeCamera(const COLLADAFW::Camera*) override { return true; }
    bool writeImage(const COLLADAFW::Image*) override { return true; }
    bool writeLight(const COLLADAFW::Light*) override { return true; }
    bool writeAnimation(const COLLADAFW::Animation*) override { return true; }
    bool writeAnimationList(const COLLADAFW::AnimationList*) override { return true; }
    bool writeSkinControllerData(const COLLADAFW::SkinControllerData*) override { return true; }
    bool writeController(const COLLADAFW::Controller*) override { return true; }
    bool writeFormulas(const COLLADAFW::Formulas*) override { return true; }
    bool writeKinematicsScene(const COLLADAFW::KinematicsScene*) override { return true; }
};

}  // namespace

void loadWithOpenCollada(const std::string& file) {
    COLLADASaxFWL::Loader loader;
    Nobody nobody;
    COLLADAFW::Root root(&loader, &nobody);
    if (!root.loadDocument(file)) throw std::runtime_error("OpenCOLLADA cannot read " + file);
}
