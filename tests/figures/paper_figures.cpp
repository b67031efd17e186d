// Makes figures of the paper with this program, and a page with their numbers.
// Usage: paper_figures FOLDER [MESHES [NUMBER...]]
// MESHES: folder of organic/cathead.obj and the like; empty or missing, the program's own samples are solved.
// NUMBER: make only these figures, and leave the page as it is. Needs a screen.
#include "figures/bakefigures.h"
#include "figures/mapfigures.h"
#include "figures/solverfigures.h"
#include "figures/studiopictures.h"
#include "views/ui/theme.h"

#include <QApplication>
#include <QDir>
#include <QTextStream>

#include <stdexcept>

using namespace autocuts;
using namespace autocuts::figures;

namespace {

const Figure table[] = {
    {2, "figure2_lambda.png", "lambda balances cuts against distortion",
     "more cuts with less distortion on the left, fewer with more on the right.",
     "the live solver at four values of lambda.", lambdaBalance},
    {4, "figure4_delta.png", "smaller delta turns soft separation into cuts (lambda 0.1)",
     "with falling delta, red hues (separation) gather in few edges.",
     "one solve, delta falling by quarters; counted are edges with a separation of 0.5 or more.", deltaSweep},
    {5, "figure5_starts.png", "the same result from every start (lambda 0.05)",
     "almost identical results from Tutte, from rigid triangles and from random places.",
     "the same starts, and a projection in which half of the triangles are turned over.", fourStarts},
    {6, "figure6_bumpycube.png", "the bumpy cube, without help and painted",
     "an automatic map with default settings, cut along the edges of the cube; ZBrush misses that cut, even "
     "with painted candidate regions.",
     "a cube of the same kind, generated, by *Unwrap*. Left with default settings, in the middle without the "
     "preference for sharp edges; right after strokes of the paint tool: blue attracts cuts to the edges in "
     "front, "
     "green keeps the others of the lid together. The live solver alone, by which the paper cuts the cube, "
     "does not find "
     "its edges here.",
     bumpyCube},
    {7, "figure7_one_edge.png", "one edge cut by hand becomes a cut line (lambda 0.35)",
     "one edge is cut by force, and the cut spreads by itself.",
     "the most strained edge is cut, delta raised and lowered again.", propagatedCut},
    {9, "figure9_regions.png", "regions without overlaps are dragged away",
     "the user selects a maximal region that does not overlap itself and moves it away, until no overlaps "
     "are "
     "left.",
     "the region tool, with real clicks and drags, on the map of a quick search that may leave overlaps, "
     "then "
     "*Pack*. The paper's model is not named; this is another one.",
     overlapRegions},
    {10, "figure10_irregular.png", "an irregular mesh, as in video games",
     "a \"video game style\" mesh that looks like one surface and consists of many parts that are not "
     "joined, and "
     "so of numerous patches.",
     "*Unwrap* with default settings on another irregular mesh.", irregularMesh},
    {11, "figure11_octopus.png", "the octopus beside Sorkine et al. 2002",
     "three maps of the octopus: that of Sorkine et al. 2002 for a distortion bound of 3 and an "
     "area-to-perimeter ratio of 10000 (over-segmented, numerous patches of one triangle or of short "
     "strips), "
     "the assisted one, and the greedy heuristic of the paper. It gives no other numbers.",
     "the octopus again. Left the region tool, in the middle *Separate overlaps* in the paper's greedy way, "
     "both "
     "on the map of a quick search that may leave overlaps; right *Unwrap*. Worst stretch is the measure of "
     "Sorkine et al.: the largest stretch or shrinking of a triangle in any direction.",
     octopusPatches},
    {12, "figure12_quads.png", "quads stay whole", "a mesh of quads; cuts never run through them.",
     "another mesh of quads. Edges of quads are drawn; diagonals can be no seams.", quadMesh},
    {13, "figure13_length_count.png", "least length or least number of cut edges (lambda 0.02)",
     "shortest cuts on the left, fewest cut edges on the right.", "both weightings of the live solver.",
     lengthOrCount},
    {14, "figure14_painted.png", "a painted texture set",
     "left a texture set, painted by hand in 3D over a model that was unwrapped with the paper's technique: "
     "normals in tangent space above, diffuse colours below. Right the final model from two sides.",
     "the model unwrapped with default settings. Scales, stripes and a pale belly are painted by rules on "
     "the "
     "vertices of a fine, smooth version of it, and `autocuts-cli bake` brings its normals and vertex "
     "colours "
     "into the map. The studio shows both in light.",
     paintedSet},
    {15, "figure15_bake.png", "details of a fine model baked for a coarse one",
     "the armadillo: a coarse model with a map by Autocuts, and the texture of a fine one baked for it.",
     "another scanned figure: `autocuts-cli unwrap` of the coarse model, then `autocuts-cli bake` of normals "
     "and "
     "occlusion from the fine one.",
     detailBake},
    {16, "figure16_light.png", "light in the texture", "a model that is lit only by its baked texture.",
     "`autocuts-cli lightbake` of a sun and a day sky into the map of *Unwrap*. The studio's own soft light "
     "falls "
     "on the model besides.",
     lightBake},
    {17, "figure17_gallery.png", "several models",
     "Hand, Elk, Octopus and Moai statue with no help; Eight and Girl with the side in front painted to have "
     "no "
     "cuts; High-Genus Tet with painted regions for cuts.",
     "*Unwrap* with default settings. Hand, Octopus and Girl are of the same kind; a camel stands for the "
     "Elk, a "
     "bust for the Moai statue, tori with holes and handles for the Eight and the Tet. Painted is what the "
     "picture shows.",
     severalModels},
};

void makeFigures(const QStringList &arguments)
{
    if (!QDir().mkpath(arguments[1]))
        throw std::runtime_error("cannot make the folder");
    FigurePage page(arguments[1], arguments.value(2));
    const QStringList chosen = arguments.mid(3);
    for (const Figure &figure : table) {
        if (figure.make && (chosen.isEmpty() || chosen.contains(QString::number(figure.number))))
            figure.make(page, figure);
    }
    if (chosen.isEmpty())
        page.write();
}

} // namespace

int main(int argc, char **argv)
{
    prepareViews();
    QApplication application(argc, argv);
    applyTheme(application, Theme::Dark);
    QTextStream err(stderr);
    if (QCoreApplication::arguments().size() < 2) {
        err << "usage: paper_figures FOLDER [MESHES [NUMBER...]]\n";
        return 2;
    }
    try {
        makeFigures(QCoreApplication::arguments());
        return 0;
    } catch (const std::exception &e) {
        err << "paper_figures: " << e.what() << '\n';
        return 1;
    }
}
