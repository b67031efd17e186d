// A Collada file for tests of conversions, and the box by which their results are compared.
#pragma once

#include "model/document/scene.h"
#include "model/io/formats/modelunits.h"

#include <QByteArray>

#include <utility>

namespace autocuts::test {

//! A Collada file with a camera, a spot light and a node named Box.
inline QByteArray viewsDae()
{
    return "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
           "version=\"1.4.1\">\n"
           "<asset><unit meter=\"0.01\"/><up_axis>Z_UP</up_axis></asset>\n"
           "<library_cameras><camera "
           "id=\"cam\"><optics><technique_common><perspective><yfov>40</yfov>\n"
           "<znear>1</znear><zfar>500</zfar></perspective></technique_common></optics></camera></"
           "library_cameras>\n"
           "<library_lights><light id=\"lamp\"><technique_common><spot><color>1 0.5 "
           "0</color><falloff_angle>60</falloff_angle></spot>\n"
           "</technique_common></light></library_lights>\n"
           "<library_geometries><geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"pa\" "
           "count=\"9\">0 0 0 100 0 0 0 0 300</float_array>\n"
           "<technique_common><accessor source=\"#pa\" count=\"3\" stride=\"3\"><param name=\"X\" "
           "type=\"float\"/><param name=\"Y\" type=\"float\"/>\n"
           "<param name=\"Z\" type=\"float\"/></accessor></technique_common></source><vertices "
           "id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/>\n"
           "</vertices><triangles count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 1 "
           "2</p></triangles></mesh></geometry>\n"
           "</library_geometries><library_visual_scenes><visual_scene id=\"s\">\n"
           "<node id=\"n1\" name=\"Box\"><instance_geometry url=\"#g\"/></node>\n"
           "<node id=\"n2\" name=\"Eye\"><translate>0 -500 0</translate><instance_camera "
           "url=\"#cam\"/></node>\n"
           "<node id=\"n3\" name=\"Lamp\"><instance_light url=\"#lamp\"/></node>\n"
           "</visual_scene></library_visual_scenes><scene><instance_visual_scene "
           "url=\"#s\"/></scene></COLLADA>";
}

//! The corners of the box of a mesh, in metres with y up.
inline std::pair<Vec3, Vec3> worldBox(const Scene &scene)
{
    const PositionMatrix p = inUnits(scene.mesh->positions, unitsOf(scene), {});
    return {p.colwise().minCoeff().transpose(), p.colwise().maxCoeff().transpose()};
}

} // namespace autocuts::test
