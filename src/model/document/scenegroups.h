// The objects and the materials of a model, with their faces.
#pragma once

#include "model/document/islands.h"
#include "model/document/scene.h"
#include "model/plain/chart.h"

#include <QList>

namespace autocuts {

//! What a model is divided into.
enum class SceneKind { Objects, Materials, Tags };

//! One object, material or tag.
struct SceneGroup
{
    SceneKind kind = SceneKind::Objects;
    int number = 0;   //!< index of its name; -1: the faces without one
    QString name;     //!< may be empty, and shared by several objects
    QList<int> faces; //!< strictly ascending, not empty
};

//! The objects or materials that have faces, in the order of the file; last the faces without a material,
//! when there are any.
std::vector<SceneGroup> sceneGroups(const Scene &scene, SceneKind kind);

//! The faces of each tag; last the faces without one, when there are any. A face of several tags belongs to
//! the first one.
std::vector<SceneGroup> tagGroups(const IslandMarks &marks, int faceCount);

//! The group of each face, as an index into groups. \param groups of sceneGroups()
std::vector<int> groupOfFaces(const std::vector<SceneGroup> &groups, int faceCount);

//! The charts, those of several objects divided: objects that touch, or lie on each other as levels of detail
//! do, may share UVs and vertices, but are apart. \param groups nothing is divided where they are materials
ChartMap dividedByObjects(ChartMap charts, const std::vector<SceneGroup> &groups);

//! A UDIM tile for each group, one after the other. An island of several groups belongs to the one that most
//! of its faces have.
//! \param first tile of the first group
//! \returns the tile of each face; empty when there are more groups than tiles
std::vector<int> tilesOfGroups(const std::vector<SceneGroup> &groups, const ChartMap &charts, int first);

} // namespace autocuts
