#include "views/actions/viewactions.h"

#include "model/pictures/picturefiles.h"
#include "model/pictures/picturereading.h"
#include "views/actions/choice.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/pictures/modelpictures.h"
#include "views/control/session/workspace.h"
#include "views/dialogs/previewdialog.h"
#include "views/ui/preferences.h"
#include "views/ui/questions.h"

#include <QFileInfo>

namespace autocuts {

namespace {

struct Toggle
{
    const char *id;
    bool ViewOptions::*field;
};

constexpr Toggle toggles[] = {{"view.smoothShading", &ViewOptions::smoothShading},
                              {"view.livePacking", &ViewOptions::livePacking},
                              {"view.wireframe", &ViewOptions::wireframe},
                              {"view.seams", &ViewOptions::seams},
                              {"view.steering", &ViewOptions::steering},
                              {"view.problems", &ViewOptions::problems},
                              {"view.fillIslands", &ViewOptions::fillIslands},
                              {"view.grid", &ViewOptions::grid},
                              {"view.rulers", &ViewOptions::rulers},
                              {"view.followMap", &ViewOptions::followMap},
                              {"view.islandMarks", &ViewOptions::islandMarks},
                              {"view.islandNumbers", &ViewOptions::islandNumbers},
                              {"view.orthographic", &ViewOptions::orthographic},
                              {"view.xray", &ViewOptions::xray}};

constexpr Choice<Coloring> colorings[] = {{"view.coloring.plain", Coloring::Plain},
                                          {"view.coloring.islands", Coloring::Islands},
                                          {"view.coloring.signedStretch", Coloring::SignedStretch},
                                          {"view.coloring.magnitude", Coloring::StretchMagnitude},
                                          {"view.coloring.paint", Coloring::PaintWeights},
                                          {"view.coloring.density", Coloring::Density},
                                          {"view.coloring.texelWeights", Coloring::TexelWeights},
                                          {"view.coloring.vertexColors", Coloring::VertexColors}};
constexpr Choice<Pattern> patterns[] = {
    {"view.pattern.none", Pattern::None},           {"view.pattern.checker", Pattern::Checker},
    {"view.pattern.lettered", Pattern::Lettered},   {"view.pattern.texture", Pattern::Texture},
    {"view.pattern.materials", Pattern::Materials}, {"view.pattern.physical", Pattern::Physical}};
constexpr Choice<ViewLayout> layouts[] = {{"view.both", ViewLayout::Both},
                                          {"view.maximize3d", ViewLayout::Only3d},
                                          {"view.maximizeUv", ViewLayout::OnlyUv}};

constexpr Choice<ViewSide> sides[] = {
    {"view.from.front", ViewSide::Front}, {"view.from.back", ViewSide::Back},
    {"view.from.right", ViewSide::Right}, {"view.from.left", ViewSide::Left},
    {"view.from.top", ViewSide::Top},     {"view.from.bottom", ViewSide::Bottom}};

QStringList imageFilters()
{
    QStringList globs;
    for (const QString &suffix : pictureSuffixes())
        globs << QStringLiteral("*.") + suffix;
    return {ViewActions::tr("Pictures (%1)").arg(globs.join(QLatin1Char(' '))),
            ViewActions::tr("All files (*)")};
}

} // namespace

ViewActions::ViewActions(const StudioContext &context, Questions &questions, QObject *parent)
    : QObject(parent), mContext(context), mQuestions(questions)
{
    connectChoices();
    connectWindow();
    connect(&context.view, &ViewState::optionsChanged, this, &ViewActions::showOptions);
    showOptions();
}

template <typename Change>
void ViewActions::connectChange(const char *id, Change change)
{
    connect(mContext.actions.action(id), &QAction::triggered, this, [this, change] {
        ViewOptions options = mContext.view.options();
        change(options);
        mContext.view.setOptions(options);
    });
}

void ViewActions::connectChoices()
{
    for (const auto &[id, field] : toggles)
        connectChange(id, [field](ViewOptions &options) { options.*field = !(options.*field); });
    for (const auto &[id, value] : colorings)
        connectChange(id, [value](ViewOptions &options) { options.coloring = value; });
    for (const auto &[id, value] : patterns) {
        if (value != Pattern::Texture) // may have to be asked for
            connectChange(id, [pattern = value](ViewOptions &options) { options.pattern = pattern; });
    }
    const auto onTriggered = [this](const char *id, auto function) {
        connect(mContext.actions.action(id), &QAction::triggered, this, function);
    };
    onTriggered("view.pattern.texture", [this] {
        const QString path = mContext.view.options().texturePath;
        if (path.isEmpty())
            askTexture();
        else
            loadTexture(path);
    });
    onTriggered("view.heatMap", [this] { nextHeatMap(); });
    onTriggered("view.texture", [this] { nextPattern(); });
    onTriggered("view.loadTexture", [this] { askTexture(); });
    onTriggered("view.preview", [this] { showPreview(); });
}

void ViewActions::connectWindow()
{
    ActionRegistry &actions = mContext.actions;
    connect(actions.action("view.frameAll"), &QAction::triggered, this, &ViewActions::frameAll);
    connect(actions.action("view.frameSelected"), &QAction::triggered, this, &ViewActions::frameSelected);
    connect(actions.action("view.panels"), &QAction::triggered, this, &ViewActions::togglePanels);
    connect(actions.action("view.resetPanels"), &QAction::triggered, this, &ViewActions::resetPanels);
    for (const auto &[id, value] : sides)
        connect(actions.action(id), &QAction::triggered, this,
                [this, side = value] { Q_EMIT lookFrom(side); });
    for (const auto &[id, value] : layouts)
        connect(actions.action(id), &QAction::triggered, this, [this, layout = value] { setLayout(layout); });
    actions.action("view.both")->setChecked(true);
}

void ViewActions::setLayout(ViewLayout layout)
{
    showChoice(mContext.actions, layouts, layout);
    if (layout == mLayout)
        return;
    mLayout = layout;
    Q_EMIT layoutChosen(layout);
}

void ViewActions::askTexture()
{
    const QString old = mContext.view.options().texturePath;
    const QString folder = old.isEmpty() ? mContext.preferences.lastFolder() : QFileInfo(old).path();
    const QString path = mQuestions.fileToOpen(tr("Load texture"), folder, imageFilters());
    if (!path.isEmpty())
        loadTexture(path);
    // The action group may have checked an action whose option was not set.
    showOptions();
}

void ViewActions::loadTexture(const QString &path)
{
    if (const QString problem = pictureProblem(path); !problem.isEmpty()) {
        mQuestions.showError({tr("The texture cannot be read: %1").arg(problem), path, 0,
                              tr("Choose a PNG, JPEG or TIFF file")});
        showOptions();
        return;
    }
    ViewOptions options = mContext.view.options();
    options.texturePath = path;
    options.pattern = Pattern::Texture;
    mContext.view.setOptions(options);
    showOptions();
}

void ViewActions::showPreview()
{
    if (!mContext.workspace.document())
        return;
    PreviewDialog dialog(mContext, mQuestions);
    mQuestions.run(dialog);
}

void ViewActions::nextHeatMap()
{
    ViewOptions options = mContext.view.options();
    if (options.coloring == Coloring::SignedStretch)
        options.coloring = Coloring::StretchMagnitude;
    else if (options.coloring == Coloring::StretchMagnitude)
        options.coloring = Coloring::Density;
    else if (options.coloring == Coloring::Density)
        options.coloring = Coloring::Plain;
    else
        options.coloring = Coloring::SignedStretch;
    mContext.view.setOptions(options);
}

//! The texture is skipped when none was chosen, those of the model when it names none.
void ViewActions::nextPattern()
{
    ViewOptions options = mContext.view.options();
    if (options.pattern == Pattern::None)
        options.pattern = Pattern::Checker;
    else if (options.pattern == Pattern::Checker)
        options.pattern = Pattern::Lettered;
    else if (options.pattern == Pattern::Lettered && !options.texturePath.isEmpty())
        options.pattern = Pattern::Texture;
    else if (options.pattern == Pattern::Materials && mContext.pictures.hasSets())
        options.pattern = Pattern::Physical;
    else if (options.pattern != Pattern::Materials && options.pattern != Pattern::Physical &&
             mContext.pictures.count() > 0)
        options.pattern = Pattern::Materials;
    else
        options.pattern = Pattern::None;
    mContext.view.setOptions(options);
}

void ViewActions::showOptions()
{
    const ViewOptions &options = mContext.view.options();
    for (const auto &[id, field] : toggles)
        mContext.actions.action(id)->setChecked(options.*field);
    showChoice(mContext.actions, colorings, options.coloring);
    showChoice(mContext.actions, patterns, options.pattern);
    mContext.solver.setLivePacking(options.livePacking);
}

} // namespace autocuts
