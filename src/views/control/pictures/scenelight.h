// The surroundings in whose light texture sets are shown.
#pragma once

#include "model/pictures/environment.h"
#include "views/state/viewstate.h"
#include "views/ui/task.h"

#include <QObject>

#include <memory>

namespace autocuts {

//! Prepares the surroundings of the view options on another thread, when they are needed first.
class SceneLight final : public QObject
{
    Q_OBJECT

public:
    explicit SceneLight(const ViewState &view, QObject *parent = nullptr);

    bool isLoading() const { return mLoading.isRunning(); }
    //! Empty until they are ready, then the last ones that could be read.
    const std::shared_ptr<const Environment> &environment() const { return mEnvironment; }

Q_SIGNALS:
    void changed();
    //! The file cannot be read. \param message translated
    void noticed(const QString &message);

private:
    void prepare();
    void takeOver(std::shared_ptr<const Environment> environment, const QString &problem);

    const ViewState &mView;
    bool mWanted = false; //!< something was asked for
    Surroundings mKind = Surroundings::Studio;
    QString mPath;
    Task mLoading;
    std::shared_ptr<const Environment> mEnvironment = std::make_shared<Environment>();
};

} // namespace autocuts
