#include <shell_origami/rviz/plugin/fold_drawing.h>

#include <OgreManualObject.h>
#include <OgreMaterialManager.h>
#include <OgreSceneManager.h>
#include <OgreSceneNode.h>
#include <OgreTechnique.h>
#include <rviz/ogre_helpers/billboard_line.h>
#include <rviz/ogre_helpers/shape.h>

#include <algorithm>

namespace shell_origami {
namespace {

// Not quite opaque: what is transparent is drawn after the paper.
const Ogre::ColourValue kMountain(0.85f, 0.05f, 0.10f, 0.95f);
const Ogre::ColourValue kValley(0.05f, 0.20f, 0.95f, 0.95f);
const Ogre::ColourValue kUnknown(0.25f, 0.25f, 0.25f, 0.95f);
const Ogre::ColourValue kGhost(0.20f, 0.65f, 0.45f, 0.40f);

constexpr double kLineWidth = 1.0 / 90;     ///< of the sheet's size
constexpr double kPointerWidth = 1.0 / 45;  ///< of the sheet's size

const Ogre::ColourValue& colorOf(DrawnLine::Kind kind) {
  switch (kind) {
    case DrawnLine::Kind::kMountain: return kMountain;
    case DrawnLine::Kind::kValley: return kValley;
    case DrawnLine::Kind::kUnknown: break;
  }
  return kUnknown;
}

std::string newMaterial() {
  static int count = 0;
  const std::string name = "shell_origami/ghost" + std::to_string(count++);
  const Ogre::MaterialPtr material = Ogre::MaterialManager::getSingleton().create(
      name, Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME);
  material->setReceiveShadows(false);
  material->setLightingEnabled(false);
  material->setCullingMode(Ogre::CULL_NONE);
  material->setSceneBlending(Ogre::SBT_TRANSPARENT_ALPHA);
  material->setDepthWriteEnabled(false);
  return name;
}

}  // namespace

FoldDrawing::FoldDrawing(Ogre::SceneManager* manager)
    : manager_(manager),
      node_(manager->getRootSceneNode()->createChildSceneNode()),
      lines_(std::make_unique<rviz::BillboardLine>(manager, node_)),
      pointer_(std::make_unique<rviz::Shape>(rviz::Shape::Sphere, manager, node_)),
      ghost_(manager->createManualObject()),
      ghost_material_(newMaterial()) {
  lines_->setColor(kUnknown.r, kUnknown.g, kUnknown.b, kUnknown.a);
  lines_->getMaterial()->setDepthCheckEnabled(false);
  ghost_->setDynamic(true);
  node_->attachObject(ghost_);
  clear();
}

FoldDrawing::~FoldDrawing() {
  lines_.reset();
  pointer_.reset();
  manager_->destroyManualObject(ghost_);
  manager_->destroySceneNode(node_);
  Ogre::MaterialManager::getSingleton().remove(
      ghost_material_, Ogre::ResourceGroupManager::DEFAULT_RESOURCE_GROUP_NAME);
}

void FoldDrawing::place(const FramePose& world) {
  node_->setPosition(world.position);
  node_->setOrientation(world.orientation);
}

void FoldDrawing::clear() {
  hidePointer();
  showLines({});
  showGhost({});
}

void FoldDrawing::showPointer(const Vector3& point, bool firm) {
  const auto width = static_cast<float>((firm ? 1 : 0.6) * kPointerWidth * size_);
  pointer_->setScale({width, width, width});
  pointer_->setPosition(toOgre(point));
  if (firm) pointer_->setColor(0.1f, 0.75f, 0.2f, 1);
  else pointer_->setColor(0.35f, 0.35f, 0.35f, 1);
  pointer_->getRootNode()->setVisible(true);
}

void FoldDrawing::hidePointer() { pointer_->getRootNode()->setVisible(false); }

void FoldDrawing::showLines(const std::vector<DrawnLine>& lines) {
  lines_->clear();
  if (lines.empty()) return;
  lines_->setMaxPointsPerLine(2);
  lines_->setNumLines(static_cast<std::uint32_t>(lines.size()));
  lines_->setLineWidth(static_cast<float>(kLineWidth * size_));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i > 0) lines_->newLine();
    for (const Vector3& end : lines[i].ends) lines_->addPoint(toOgre(end), colorOf(lines[i].kind));
  }
}

void FoldDrawing::showGhost(const std::vector<Vector3>& corners) {
  ghost_->clear();
  if (corners.empty()) return;
  ghost_->estimateVertexCount(corners.size());
  ghost_->begin(ghost_material_, Ogre::RenderOperation::OT_TRIANGLE_LIST);
  for (const Vector3& corner : corners) {
    ghost_->position(toOgre(corner));
    ghost_->colour(kGhost);
  }
  ghost_->end();
}

}  // namespace shell_origami
