// A figure with head, arms and legs, extruded from a block and subdivided: quads only, genus 0.
#include "model/samples/samplemodels.h"

#include <array>
#include <map>

namespace autocuts::samples {

namespace {

//! The block that is extruded: 3 x 3 x 2 cells, wider at the shoulders, symmetric in x.
class Trunk
{
public:
    static constexpr std::array<int, 3> cells{3, 3, 2};

    explicit Trunk(PolygonModel &model) : mModel(model)
    {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int end : {0, 1})
                addSide(axis, end);
        }
    }

    //! The face at one end (0 or 1) of an axis. The cell's index along that axis is ignored.
    int face(int axis, int end, std::array<int, 3> cell) const
    {
        cell[axis] = end;
        return mFaces.at({axis, cell});
    }

private:
    int point(const std::array<int, 3> &place)
    {
        static constexpr double halfWidth[] = {0.21, 0.19, 0.26, 0.27};
        static constexpr double height[] = {0.92, 1.10, 1.30, 1.50};
        static constexpr double halfDepth[] = {0.15, 0.13, 0.16, 0.11};
        const auto [found, isNew] = mPoints.try_emplace(place, 0);
        if (isNew) {
            const int level = place[1];
            const double x = (place[0] - 1.5) / 1.5;
            found->second = mModel.addPoint({halfWidth[level] * (place[0] % 3 == 0 ? x : 1.1 * x),
                                             height[level], halfDepth[level] * (place[2] - 1)});
        }
        return found->second;
    }

    void addSide(int axis, int end)
    {
        const int across = (axis + (end == 1 ? 1 : 2)) % 3;
        const int up = 3 - axis - across;
        for (int i = 0; i < cells[across]; ++i) {
            for (int j = 0; j < cells[up]; ++j) {
                std::array<int, 3> place{};
                place[axis] = end * cells[axis];
                const auto at = [&](int di, int dj) {
                    place[across] = i + di;
                    place[up] = j + dj;
                    return point(place);
                };
                std::vector<int> corners{at(0, 0), at(1, 0), at(1, 1), at(0, 1)};
                std::array<int, 3> cell{};
                cell[axis] = end;
                cell[across] = i;
                cell[up] = j;
                mFaces[{axis, cell}] = mModel.addFace(std::move(corners));
            }
        }
    }

    PolygonModel &mModel;
    std::map<std::array<int, 3>, int> mPoints;
    std::map<std::pair<int, std::array<int, 3>>, int> mFaces;
};

//! Among the faces added since `first`, the one whose centre is farthest along a direction.
int farthestFace(const PolygonModel &model, int first, const Vec3 &direction)
{
    int best = first;
    double bestReach = -1e9;
    for (int f = first; f < static_cast<int>(model.faces.size()); ++f) {
        double reach = 0;
        for (int v : model.faces[f])
            reach += model.points[v].dot(direction) / static_cast<double>(model.faces[f].size());
        // The margin makes sure that rounding does not decide between two mirrored faces: the first one is
        // taken.
        if (reach > bestReach + 1e-9) {
            bestReach = reach;
            best = f;
        }
    }
    return best;
}

void addLeg(PolygonModel &model, const Trunk &trunk, int column)
{
    const double side = column == 0 ? -1 : 1;
    const std::vector<int> sole{trunk.face(1, 0, {column, 0, 0}), trunk.face(1, 0, {column, 0, 1})};
    model.extrude(sole, {side * 0.02, -0.14, 0}, {1.0, 0.3, 0.8});
    model.extrude(sole, {side * 0.015, -0.26, 0.01}, {0.85, 0.5, 0.8});
    model.extrude(sole, {0, -0.37, -0.03}, {0.8, 1, 0.75});
    const int ankle = static_cast<int>(model.faces.size());
    model.extrude(sole, {0, -0.11, 0.01}, {1.25, 1, 1.3});
    const std::vector<int> front{farthestFace(model, ankle, Vec3::UnitZ())};
    model.extrude(front, {side * 0.02, -0.015, 0.10}, {1.3, 0.8, 1});
    model.extrude(front, {side * 0.01, -0.01, 0.08}, {0.9, 0.7, 1});
}

void addArm(PolygonModel &model, const Trunk &trunk, int end)
{
    const double side = end == 0 ? -1 : 1;
    const std::vector<int> tip{trunk.face(0, end, {0, 2, 0}), trunk.face(0, end, {0, 2, 1})};
    model.extrude(tip, {side * 0.10, -0.02, 0}, {0.3, 0.75, 0.75});
    model.extrude(tip, {side * 0.20, -0.09, 0}, {0.5, 0.8, 0.9});
    model.extrude(tip, {side * 0.28, -0.09, 0.05}, {1, 0.7, 0.75});
    const int palm = static_cast<int>(model.faces.size());
    model.extrude(tip, {side * 0.13, -0.03, 0.03}, {1, 0.9, 1.7});
    const std::vector<int> thumb{farthestFace(model, palm, Vec3::UnitZ())};
    model.extrude(thumb, {side * 0.03, -0.01, 0.08}, {0.8, 1, 1});
    model.extrude(thumb, {side * 0.06, 0.0, 0.08}, {0.8, 0.9, 0.9});
    for (const int k : {0, 1}) {
        const std::vector<int> finger{tip[k]};
        const double spread = k == 0 ? -0.02 : 0.03;
        model.extrude(finger, {side * 0.08, -0.02, spread}, {1, 0.9, 0.75});
        model.extrude(finger, {side * 0.07, -0.03, 0}, {1, 0.85, 0.85});
    }
}

void addHead(PolygonModel &model, const Trunk &trunk)
{
    const std::vector<int> crown{trunk.face(1, 1, {1, 0, 0}), trunk.face(1, 1, {1, 0, 1})};
    model.extrude(crown, {0, 0.05, 0.0}, {0.9, 1, 0.75});
    model.extrude(crown, {0, 0.07, 0.02}, {1, 1, 1});
    model.extrude(crown, {0, 0.06, 0.03}, {2.0, 1, 2.0});
    const int face = static_cast<int>(model.faces.size());
    model.extrude(crown, {0, 0.17, 0}, {1.15, 1, 1.15});
    const std::vector<int> nose{farthestFace(model, face, Vec3::UnitZ())};
    const std::vector<int> leftEar{farthestFace(model, face, {-1, 0, -0.2})};
    const std::vector<int> rightEar{farthestFace(model, face, {1, 0, -0.2})};
    model.extrude(crown, {0, 0.15, -0.01}, {0.75, 1, 0.75});
    model.extrude(nose, {0, -0.02, 0.04}, {0.45, 0.5, 1});
    model.extrude(nose, {0, -0.02, 0.05}, {0.7, 0.6, 1});
    for (const auto &[ear, side] : {std::pair{leftEar, -1.0}, std::pair{rightEar, 1.0}}) {
        model.extrude(ear, {side * 0.03, 0.0, 0}, {1, 0.4, 0.4});
        model.extrude(ear, {side * 0.07, 0.03, -0.03}, {1, 1.7, 1.4});
    }
}

} // namespace

PolygonModel makeCharacter()
{
    PolygonModel model;
    model.beginObject(QStringLiteral("character"));
    model.useMaterial(QStringLiteral("skin"));
    const Trunk trunk(model);
    for (const int end : {0, 1}) {
        addLeg(model, trunk, end == 0 ? 0 : Trunk::cells[0] - 1);
        addArm(model, trunk, end);
    }
    addHead(model, trunk);
    model.subdivide();
    model.subdivide();
    return model;
}

} // namespace autocuts::samples
