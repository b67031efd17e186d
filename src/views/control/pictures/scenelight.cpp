#include "views/control/pictures/scenelight.h"

#include "model/pictures/picturefiles.h"

namespace autocuts {

SceneLight::SceneLight(const ViewState &view, QObject *parent) : QObject(parent), mView(view)
{
    connect(&view, &ViewState::optionsChanged, this, &SceneLight::prepare);
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
    struct Light
    {
        std::shared_ptr<const Environment> environment;
        QString problem;
    };
    mLoading.start(
        [kind = mKind, path](const std::atomic<bool> &stop) {
            Light light;
            Picture panorama;
            if (kind != Surroundings::File) {
                panorama = kind == Surroundings::Sky ? skyPanorama() : studioPanorama();
            } else if (auto read = readPicture(path)) {
                panorama = std::move(read).value();
            } else {
                light.problem = read.error().toString();
            }
            light.environment = std::make_shared<const Environment>(prepareEnvironment(panorama, &stop));
            return light;
        },
        [this](Light light) { takeOver(std::move(light.environment), light.problem); },
        [this](const QString &message) { takeOver(nullptr, message); });
    Q_EMIT changed();
}

void SceneLight::takeOver(std::shared_ptr<const Environment> environment, const QString &problem)
{
    if (environment && !environment->isEmpty())
        mEnvironment = std::move(environment);
    Q_EMIT changed();
    if (!problem.isEmpty())
        Q_EMIT noticed(tr("The surroundings cannot be shown: %1").arg(problem));
}

} // namespace autocuts
