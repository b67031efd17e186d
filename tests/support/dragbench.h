// Two views whose drag tool pulls at the map of a grid, for tests of that tool.
#pragma once

#include "support/canvases.h"
#include "support/editsupport.h"
#include "views/tools/dragtool.h"

#include <QTest>

#include <cmath>

namespace autocuts::test {

class DragBench
{
protected:
    void begin()
    {
        mStudio = Canvases::onGrid(8);
        mStudio->tools.setTool(QStringLiteral("drag"));
        QCOMPARE(mStudio->tools.tool()->id(), QStringLiteral("drag"));
        mStudio->select(SelectionMode::Vertices);
    }

    using Row = Eigen::RowVector2d;
    Document &document() { return mStudio->document(); }
    UvView &view() { return mStudio->uv; }
    DragTool &tool() { return *qobject_cast<DragTool *>(mStudio->tools.tool()); }
    QPoint pixel(const Vec2 &uv) { return view().camera().toScreen(uv).toPoint(); }
    void drag(const Vec2 &from, const Vec2 &to) { Canvases::drag(view(), {pixel(from), pixel(to)}); }
    void openOneIsland(const MeshPtr &mesh = grid(8))
    {
        Scene scene = sceneOf(mesh);
        UvMatrix uv(scene.mesh->cornerCount(), 2);
        for (int c = 0; c < scene.mesh->cornerCount(); ++c)
            uv.row(c) = scene.mesh->cornerPosition(c).head<2>();
        scene.uvSets = {{QStringLiteral("UV"), uv}};
        const MapCamera camera = view().camera();
        mStudio->open(std::make_unique<Document>(std::move(scene)));
        view().setCamera(camera);
        mStudio->select(SelectionMode::Vertices);
    }
    //! By the wheel, to the nearest notch.
    void setRadius(double uv)
    {
        const double notches = std::log(uv * 200 / tool().radius()) / std::log(1.15);
        Canvases::turnWheel(view(), {250, 250}, static_cast<int>(std::lround(120 * notches)),
                            Qt::ShiftModifier);
    }
    //! The soup corner that the shown map has nearest to a place.
    int soupAt(const Vec2 &uv)
    {
        int row = -1;
        (mStudio->shown.uv().rowwise() - uv.transpose()).rowwise().norm().minCoeff(&row);
        return row;
    }

    std::unique_ptr<Canvases> mStudio;
};

} // namespace autocuts::test
