#include "guide/guidewindow.h"

#include "model/plain/uvlayout.h"
#include "support/canvases.h"

#include <QComboBox>
#include <QDialog>
#include <QDockWidget>
#include <QLineEdit>
#include <QPainter>

namespace autocuts::guide {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int jpegQuality = 86;
constexpr int gap = 6; // pixels between before and after

} // namespace

void GuideWindow::openNew()
{
    mArtist.reset(); // before the next one: it is the active window
    mArtist = std::make_unique<test::Artist>(QSize(1600, 900), test::Look::Full);
}

QDockWidget *GuideWindow::dock(const char *name)
{
    return studio().window.findChild<QDockWidget *>(QLatin1StringView(name));
}

void GuideWindow::fail(const QString &problem)
{
    if (mProblem.isEmpty())
        mProblem = problem;
}

void GuideWindow::settle()
{
    QTest::qWait(400);
    // The mouse leaves no marks behind.
    QCoreApplication::processEvents();
}

void GuideWindow::lookAway()
{
    test::Canvases::moveMouse(map(), {40, 40});
}

void GuideWindow::save(const QImage &image, const QString &name)
{
    const QString path = mFolder.filePath(name + u".jpg"_s);
    if (!image.save(path, nullptr, jpegQuality))
        fail(u"cannot write "_s + path);
}

void GuideWindow::window(const QString &name)
{
    settle();
    save(studio().window.grab().toImage(), name);
}

void GuideWindow::part(const QString &name, const QList<const QWidget *> &widgets)
{
    settle();
    QRect area;
    for (const QWidget *widget : widgets)
        area |= QRect(widget->mapTo(&studio().window, QPoint()), widget->size());
    save(studio().window.grab(area).toImage(), name);
}

QImage GuideWindow::both()
{
    settle();
    return beside(model().picture(), map().picture());
}

QImage GuideWindow::beside(const QImage &left, const QImage &right)
{
    QImage image(left.width() + gap + right.width(), std::max(left.height(), right.height()),
                 QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.drawImage(0, 0, left);
    painter.drawImage(left.width() + gap, 0, right);
    return image;
}

void GuideWindow::sample(const char *action)
{
    studio().action(action)->trigger();
    if (!studio().document())
        fail(u"no sample"_s);
}

void GuideWindow::unwrapped(const char *action)
{
    sample(action);
    unwrap();
}

void GuideWindow::unwrap()
{
    studio().setQuality(unwrap::UnwrapQuality::Draft);
    artist().runJob("uv.unwrap");
    studio().action("view.coloring.islands")->trigger();
    frame();
}

void GuideWindow::solve(int steps)
{
    if (!studio().context.solver.isRunning())
        studio().press(Qt::Key_Space);
    if (!studio().runsTo(studio().context.solver.status().iteration + steps))
        fail(u"the solver does not run"_s);
}

void GuideWindow::pause()
{
    if (studio().context.solver.isRunning())
        studio().press(Qt::Key_Space);
    studio().solverRests();
}

void GuideWindow::standStill()
{
    settle();
    (void)QTest::qWaitFor(
        [&] {
            const auto map = studio().context.solver.map();
            return map && studio().context.shownMap.uv() == soupUv(document().mesh(), map->uv);
        },
        test::patience);
}

void GuideWindow::solveToRest()
{
    solve(1);
    studio().solverRests();
}

void GuideWindow::workInFolder()
{
    mFolder.makeAbsolute();
    QDir::setCurrent(studio().folder.path());
}

void GuideWindow::ask(const char *action, const std::function<void(QDialog &)> &work)
{
    studio().answers->onDialog = [&](QDialog &dialog) {
        dialog.open();
        (void)QTest::qWaitForWindowExposed(&dialog);
        QApplication::setActiveWindow(&dialog);
        work(dialog);
        const int result = dialog.result();
        dialog.close();
        return result;
    };
    studio().action(action)->trigger();
    studio().answers->onDialog = nullptr;
    QApplication::setActiveWindow(&studio().window);
}

void GuideWindow::type(QDialog &dialog, const char *name, const QString &text)
{
    auto *edit = dialog.findChild<QLineEdit *>(QLatin1StringView(name));
    QTest::mouseClick(edit, Qt::LeftButton);
    edit->selectAll();
    if (text.isEmpty())
        QTest::keyClick(edit, Qt::Key_Delete);
    QTest::keyClicks(edit, text);
}

void GuideWindow::choose(QWidget &parent, const char *name, int entry)
{
    auto *box = parent.findChild<QComboBox *>(QLatin1StringView(name));
    QTest::keyClick(box, Qt::Key_Home);
    for (int i = 0; i < entry; ++i)
        QTest::keyClick(box, Qt::Key_Down);
}

} // namespace autocuts::guide
