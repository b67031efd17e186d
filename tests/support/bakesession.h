// A studio with a box to bake into and one to bake from, and the bake dialog used by events.
#pragma once

#include "commands/changesettings.h"
#include "jobs/bakechoice.h"
#include "model/io/meshes/meshfile.h"
#include "support/mappedmodels.h"
#include "support/studiosession.h"
#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/dialogs/bakedialog.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>

namespace autocuts::test {

using namespace Qt::Literals::StringLiterals;

//! The dialog, used by events.
struct DialogUser
{
    QDialog &dialog;

    template <class Widget>
    Widget *find(const char *name) const
    {
        return dialog.findChild<Widget *>(QLatin1StringView(name));
    }
    void type(const char *name, const QString &text) const
    {
        auto *edit = find<QLineEdit>(name);
        QTest::mouseClick(edit, Qt::LeftButton);
        edit->selectAll();
        QTest::keyClicks(edit, text);
    }
    void typeCage(const QString &text) const
    {
        auto *number = find<QDoubleSpinBox>("cage")->findChild<QLineEdit *>();
        number->setFocus();
        number->selectAll();
        QTest::keyClicks(number, text);
    }
    //! Ticks or clears a map by the space bar.
    void toggle(int row) const
    {
        auto *maps = find<QListWidget>("maps");
        maps->setFocus();
        maps->setCurrentRow(row);
        QTest::keyClick(maps, Qt::Key_Space);
    }
    QString problem() const { return find<QLabel>("problem")->text(); }
    jobs::BakeChoice choice() const { return static_cast<BakeDialog &>(dialog).choice(); }
    int bake() const
    {
        QTest::mouseClick(find<QPushButton>("bake"), Qt::LeftButton);
        return dialog.result();
    }
};

//! A studio with a box, and a larger box to bake from.
struct BakeSession : StudioSession
{
    QString low = folder.filePath(u"low.obj"_s), high = folder.filePath(u"high.obj"_s);
    QSignalSpy done{&context.map, &MapController::done}, failed{&context.map, &MapController::failed};

    explicit BakeSession(bool twoTiles = false)
    {
        MappedModel box = mapped(test::box(4), boxMap());
        for (Eigen::Index corner = 0; twoTiles && corner < box.uv.rows(); ++corner)
            box.uv(corner, 0) += box.uv(corner, 0) > 0.65 ? 1 : 0; // two sides of the box
        write(low, box);
        write(high, {test::box(9, Vec3(2.02, 2.02, 2.02)), UvMatrix(0, 2)});
        context.files.open(low);
        jobsRest();
        setTexture(64);
    }
    void setTexture(int size)
    {
        PackingSettings packing = document()->packingSettings();
        packing.setTexture(size, size);
        pushCommand(std::make_unique<ChangeSettings>(*document(), packing));
    }
    static void write(const QString &path, const MappedModel &model)
    {
        Scene scene;
        scene.mesh = model.mesh;
        scene.objectNames = {u"box"_s};
        scene.faceMaterial.assign(static_cast<std::size_t>(model.mesh->faceCount()), -1);
        if (model.uv.rows() > 0)
            scene.uvSets = {{u"UVMap"_s, model.uv}};
        QVERIFY(writeMesh(scene, path).ok());
    }
    void bake(const std::function<int(const DialogUser &)> &user)
    {
        answers->onDialog = [&](QDialog &dialog) {
            dialog.open();
            [[maybe_unused]] const bool seen = QTest::qWaitForWindowExposed(&dialog);
            QApplication::setActiveWindow(&dialog);
            return user({dialog});
        };
        action("uv.bake")->trigger();
        answers->onDialog = nullptr;
        QApplication::setActiveWindow(&window);
    }
    QString file(const char *name) const { return folder.filePath(QString::fromUtf8(name)); }
};

} // namespace autocuts::test
