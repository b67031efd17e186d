#include "views/control/scenelight.h"

#include "model/io/picturefiles.h"
#include "views/ui/pooltask.h"

#include <QPointer>

namespace autocuts {

SceneLight::SceneLight(const ViewState &view, QObject *parent) : QObject(parent), mView(view)
{
    connect(&view, &ViewState::optionsChanged, this, &SceneLight::prepare);
}

SceneLight::~SceneLight()
{
    if (mLoading)
        *mLoading = true;
}

void SceneLight::prepare()
{
    const ViewOptions &options = mView.options();
    const QString path = options.surroundings == Surroundings::File ? options.surroundingsPath : QString();
    const bool lit = options.pattern == Pattern::Physical || options.pattern == Pattern::Baked;
    if (!lit || (mWanted && options.surroundings == mKind && path == mPath))
        return;
    mWanted = true;
    mKind = options.surroundings;
    mPath = path;
    if (mLoading)
        *mLoading = true;
    mLoading = std::make_shared<std::atomic<bool>>(false);
    // The result is passed to the GUI thread, and ignored there when something else is wanted meanwhile.
    struct Light
    {
        std::shared_ptr<const Environment> environment;
        QString problem;
    };
    const auto isWanted = [self = QPointer<SceneLight>(this), stop = mLoading] {
        return self && self->mLoading == stop;
    };
    runOnPool(
        backgroundPool(),
        [kind = mKind, path, stop = mLoading] {
            Light light;
            Picture panorama;
            if (kind != Surroundings::File) {
                panorama = kind == Surroundings::Sky ? skyPanorama() : studioPanorama();
            } else if (auto read = readPicture(path)) {
                panorama = std::move(read).value();
            } else {
                light.problem = read.error().toString();
            }
            light.environment = std::make_shared<const Environment>(prepareEnvironment(panorama, stop.get()));
            return light;
        },
        [this, isWanted](Light light) {
            if (isWanted())
                takeOver(std::move(light.environment), light.problem);
        },
        [this, isWanted](const QString &message) {
            if (isWanted())
                takeOver(nullptr, message);
        });
    Q_EMIT changed();
}

void SceneLight::takeOver(std::shared_ptr<const Environment> environment, const QString &problem)
{
    mLoading.reset();
    if (environment && !environment->isEmpty())
        mEnvironment = std::move(environment);
    Q_EMIT changed();
    if (!problem.isEmpty())
        Q_EMIT noticed(tr("The surroundings cannot be shown: %1").arg(problem));
}

} // namespace autocuts
