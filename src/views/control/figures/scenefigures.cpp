#include "views/control/figures/scenefigures.h"

#include "model/document/materialcolor.h"
#include "model/plain/groupfigures.h"

#include <algorithm>

namespace autocuts {

std::vector<SceneFigures> sceneFigures(const Document &document, SceneKind kind,
                                       const std::vector<double> &distortion)
{
    const Scene &scene = document.state().scene;
    std::vector<SceneGroup> groups = sceneGroups(scene, kind);
    const std::vector<int> groupOf = groupOfFaces(groups, scene.mesh->faceCount());
    const std::vector<metrics::GroupFigures> measured =
        metrics::groupFigures(*scene.mesh, document.islands().charts(), document.uv(), groupOf,
                              static_cast<int>(groups.size()), distortion);
    std::vector<SceneFigures> figures(groups.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
        SceneFigures &own = figures[g];
        own.group = std::move(groups[g]);
        if (kind == SceneKind::Materials)
            own.color = shownMaterialColor(scene, own.group.number);
        own.islands = measured[g].charts;
        own.distortion = measured[g].symDirichlet;
        own.texelDensity = measured[g].density * document.packingSettings().textureSize;
        own.share = measured[g].uvArea / document.packingSettings().tileHeight();
    }
    countHidden(document, figures);
    return figures;
}

void countHidden(const Document &document, std::vector<SceneFigures> &figures)
{
    const std::vector<bool> &hidden = document.hidden();
    for (SceneFigures &own : figures) {
        const QList<int> &faces = own.group.faces;
        const auto count =
            hidden.empty() ? 0 : std::count_if(faces.begin(), faces.end(), [&](int f) { return hidden[f]; });
        own.hiddenFaces = static_cast<int>(count);
    }
}

} // namespace autocuts
