// Pictures of the chapters See what is wrong, Save and hand on, and Bake.
#include "guide/chapterpictures.h"
#include "model/document/document.h"
#include "model/io/meshes/meshfile.h"
#include "support/canvases.h"

#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QPushButton>
#include <QSpinBox>

namespace autocuts::guide {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Changes lines of an OBJ file.
void changeLines(const QString &from, const QString &to,
                 const std::function<QString(const QString &)> &change)
{
    QFile file(from), changed(to);
    if (!file.open(QIODevice::ReadOnly) || !changed.open(QIODevice::WriteOnly))
        return;
    for (const QString &line : QString::fromUtf8(file.readAll()).split(u'\n'))
        changed.write((change(line) + u'\n').toUtf8());
}

//! Makes the head of the character larger.
QString withLargeHead(const QString &line)
{
    const QStringList words = line.split(u' ', Qt::SkipEmptyParts);
    if (words.size() < 4 || words[0] != u"v"_s)
        return line;
    constexpr double neck = 1.55, growth = 1.4;
    const double x = words[1].toDouble(), y = words[2].toDouble(), z = words[3].toDouble();
    if (y < neck)
        return line;
    return u"v %1 %2 %3"_s.arg(x * growth).arg(neck + (y - neck) * growth).arg(z * growth);
}

} // namespace

void seeing(GuideWindow &guide)
{
    guide.workInFolder();
    guide.unwrapped("file.sample.machine");
    guide.studio().action("view.coloring.plain")->trigger();
    guide.studio().action("view.pattern.lettered")->trigger();
    QTest::qWait(2000); // the cells are drawn on another thread
    guide.save(guide.both(), u"lettered"_s);

    guide.studio().action("view.pattern.none")->trigger();
    guide.studio().action("view.coloring.density")->trigger();
    guide.artist().use("select.islands");
    const QList<QPoint> places = guide.artist().placesOn(guide.map(), 40);
    for (const int i : {3, 20, 33}) {
        guide.artist().click("", guide.map(), places[i]);
        guide.studio().press(Qt::Key_S);
        QTest::keyClicks(&guide.map(), u"0.6"_s);
        QTest::keyClick(&guide.map(), Qt::Key_Return);
        guide.artist().use("tool.select");
    }
    guide.studio().action("select.none")->trigger();
    guide.lookAway();
    guide.save(guide.both(), u"density"_s);

    guide.openNew();
    guide.workInFolder();
    guide.sample("file.sample.torus");
    (void)writeMesh(guide.document().state().scene, u"torus.obj"_s);
    int face = 0;
    changeLines(u"torus.obj"_s, u"torus_open.obj"_s, [&face](const QString &line) {
        const bool gone = line.startsWith(u"f "_s) && ++face <= 60;
        return gone ? QString() : line;
    });
    guide.artist().open(u"torus_open.obj"_s);
    guide.dock("doctor")->raise();
    guide.settle();
    auto *count = guide.dock("doctor")->findChild<QLabel *>(u"finding0"_s);
    Q_EMIT count->linkActivated({});
    guide.part(u"doctor"_s, {guide.dock("doctor"), &guide.model()});
}

void handingOn(GuideWindow &guide)
{
    guide.workInFolder();
    guide.unwrapped("file.sample.character");
    guide.studio().action("view.pattern.checker")->trigger();
    (void)writeMesh(guide.document().state().scene, u"character.obj"_s);
    changeLines(u"character.obj"_s, u"character_2.obj"_s, withLargeHead);
    guide.pair(u"relink"_s, guide.model(), [&] {
        guide.studio().answers->filesToOpen = {QDir().absoluteFilePath(u"character_2.obj"_s)};
        guide.artist().runJob("file.relink");
    });
    guide.ask("file.exportMesh", [&](QDialog &dialog) {
        auto *format = dialog.findChild<QComboBox *>();
        format->setCurrentIndex(format->findData(u"ply"_s));
        dialog.findChild<QLineEdit *>()->setText(u"character_uv.ply"_s);
        guide.settle();
        guide.save(dialog.grab().toImage(), u"export"_s);
    });
    guide.ask("file.exportLayout", [&](QDialog &dialog) {
        for (QLineEdit *edit : dialog.findChildren<QLineEdit *>()) {
            if (edit->text().endsWith(u".png"_s))
                edit->setText(u"map.png"_s);
        }
        guide.settle();
        guide.save(dialog.grab().toImage(), u"exportlayout"_s);
        dialog.accept();
    });
    (void)guide.studio().jobsRest();
    const QImage layout = QImage(u"map.png"_s).scaledToWidth(900, Qt::SmoothTransformation);
    if (layout.isNull())
        guide.fail(u"no picture of the map"_s);
    QImage picture(layout.size(), QImage::Format_RGB32);
    picture.fill(Qt::white);
    QPainter(&picture).drawImage(0, 0, layout);
    guide.save(picture, u"picture"_s);
    guide.ask("uv.transfer", [&](QDialog &dialog) {
        GuideWindow::type(dialog, "path", u"character.obj"_s);
        guide.settle();
        guide.save(dialog.grab().toImage(), u"transfer"_s);
    });
}

void lighting(GuideWindow &guide)
{
    guide.workInFolder();
    guide.unwrapped("file.sample.machine");
    guide.studio().action("view.coloring.plain")->trigger();
    guide.ask("uv.bakeLight", [&](QDialog &dialog) {
        dialog.findChild<QSpinBox *>(u"size"_s)->setValue(1024);
        dialog.findChild<QSpinBox *>(u"samples"_s)->setValue(64);
        dialog.findChild<QDoubleSpinBox *>(u"azimuth"_s)->setValue(300);
        dialog.findChild<QWidget *>(u"path"_s)->findChild<QLineEdit *>()->setText(u"machine_light.png"_s);
        guide.settle();
        guide.save(dialog.grab().toImage(), u"lightdialog"_s);
        QTest::mouseClick(dialog.findChild<QPushButton *>(u"bake"_s), Qt::LeftButton);
    });
    (void)guide.studio().jobsRest();
    guide.studio().action("view.wireframe")->trigger();
    guide.studio().action("view.seams")->trigger();
    guide.save(guide.both(), u"lightbake"_s);
}

} // namespace autocuts::guide
