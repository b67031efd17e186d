// How files of each format are read and written: the functions of the formats, one row for each.
#pragma once

#include "model/io/assimp/assimpsource.h"
#include "model/io/formats/filesource.h"

#include <atomic>

namespace autocuts {

//! How a format holds roughness and metalness.
enum class RoughnessPictures {
    Apart,  //!< a picture for each
    AsGltf, //!< in one picture: roughness is green, metalness blue
    None
};

//! What a new file of a format can hold. The rest is lost.
struct FormatLimits
{
    QString name{};          //!< for people
    bool nodes = true;       //!< the hierarchy, lights, cameras, bones and animations
    bool objects = true;     //!< more than one
    bool materials = true;   //!< and their pictures
    bool normals = true;     //!< and vertex colours
    bool polygons = true;    //!< false: triangles only
    bool animations = true;  //!< more than one, and a rest pose without any
    bool smoothing = false;  //!< smoothing groups
    bool partialUvs = false; //!< corners without UVs
    bool comments = false;
    bool doubles = false; //!< coordinates in double precision
    std::size_t uvSets = maxAssimpUvSets;
    RoughnessPictures roughness = RoughnessPictures::Apart;
};

struct FormatCalls
{
    QString suffix; //!< in lower case
    Result<Scene> (*read)(const QString &path, const std::atomic<bool> *stop);
    //! A new file, of a scene from another format; null: none is written.
    SceneWriter write = nullptr;
    //! It is of what Assimp reads of the scene's file: with nodes, bones and animations.
    bool takesNodes = false;
    //! The files that are written besides the path; null: none.
    QStringList (*filesBeside)(const Scene &scene, const QString &path) = nullptr;
    FormatLimits limits = {};
};

//! The calls for a format; those of Assimp's reader where it has no row. \param suffix lower-case
const FormatCalls &callsOf(const QString &suffix);

} // namespace autocuts
