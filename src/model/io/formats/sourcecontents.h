// What a model file holds besides polygons, objects, materials and UVs.
#pragma once

namespace autocuts {

//! Contents of a file that a format may not be able to hold. The user is told of them before an export.
struct SourceContents
{
    bool bones = false, shapeKeys = false, animations = false, lightsOrCameras = false,
         embeddedTextures = false, hierarchy = false;
    bool severalAnimations = false;
    bool otherAnimations = false;    //!< of more than the places of nodes: shape keys, materials, cameras
    bool dualQuaternions = false;    //!< bones bend meshes by them, not by matrices
    bool otherScaling = false;       //!< children inherit scales by another rule than that of matrices
    bool shapesWithoutFaces = false; //!< curves, NURBS surfaces
    bool stereoCameras = false;
    bool instances = false;    //!< several objects share a mesh
    bool splitObjects = false; //!< objects are one mesh for each of their materials
    bool comments = false;     //!< comments, groups and smoothing groups of OBJ files
};

} // namespace autocuts
