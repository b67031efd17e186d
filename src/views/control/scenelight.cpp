#include "views/control/scenelight.h"

#include "model/io/picturefiles.h"

#include <QCoreApplication>
#include <QPointer>
#include <QThreadPool>

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
    if (options.pattern != Pattern::Physical || (mWanted && options.surroundings == mKind && path == mPath))
        return;
    mWanted = true;
    mKind = options.surroundings;
    mPath = path;
    if (mLoading)
        *mLoading = true;
    mLoading = std::make_shared<std::atomic<bool>>(false);
    // The result is passed to the GUI thread, and ignored there when something else is wanted meanwhile.
    QThreadPool::globalInstance()->start(
        [kind = mKind, path, stop = mLoading, self = QPointer<SceneLight>(this)] {
            QString problem;
            Picture panorama;
            if (kind != Surroundings::File) {
                panorama = kind == Surroundings::Sky ? skyPanorama() : studioPanorama();
            } else if (auto read = readPicture(path)) {
                panorama = std::move(read).value();
            } else {
                problem = read.error().toString();
            }
            const auto environment =
                std::make_shared<const Environment>(prepareEnvironment(panorama, stop.get()));
            QMetaObject::invokeMethod(
                QCoreApplication::instance(),
                [self, stop, environment, problem] {
                    if (self && self->mLoading == stop)
                        self->takeOver(environment, problem);
                },
                Qt::QueuedConnection);
        });
    Q_EMIT changed();
}

void SceneLight::takeOver(std::shared_ptr<const Environment> environment, const QString &problem)
{
    mLoading.reset();
    if (!environment->isEmpty())
        mEnvironment = std::move(environment);
    Q_EMIT changed();
    if (!problem.isEmpty())
        Q_EMIT noticed(tr("The surroundings cannot be shown: %1").arg(problem));
}

} // namespace autocuts
