// How long the GUI thread is busy with the events of each of an artist's gestures, in a whole session.
//
//   bench_gestures MESH
//
// Prints a line for each gesture: events, median and worst, in milliseconds. Drawing is left out by switching
// the window's updates off, because software OpenGL says nothing about a real machine.
#include "support/artistsession.h"
#include "views/canvas/canvas.h"

#include <QApplication>

#include <algorithm>
#include <cstdio>

using namespace autocuts;

int main(int argc, char *argv[])
{
    QApplication application(argc, argv);
    if (QApplication::arguments().size() != 2) {
        std::fputs("usage: bench_gestures MESH\n", stderr);
        return 2;
    }
    test::Artist artist({1400, 900}, test::Look::Full);
    artist.studio.window.setUpdatesEnabled(false);
    const QString problem = test::runArtistSession(artist, QApplication::arguments()[1]);
    for (const auto &[gesture, times] : artist.times()) {
        std::vector<double> sorted = times;
        std::sort(sorted.begin(), sorted.end());
        std::printf("%-42s %4zu events, median %7.2f ms, worst %7.2f ms\n", qPrintable(gesture),
                    sorted.size(), sorted[sorted.size() / 2], sorted.back());
    }
    if (!problem.isEmpty())
        std::fprintf(stderr, "bench_gestures: %s\n", qPrintable(problem));
    return problem.isEmpty() ? 0 : 1;
}
