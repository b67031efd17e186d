// The best map of a running job, shown in place of the document's.
#pragma once

#include "solver/unwrap/unwrapoptions.h"
#include "views/ui/task.h"

#include <QObject>

#include <functional>

namespace autocuts {

class ShownMap;
class Workspace;

//! Shows the maps of one job after the other in ShownMap. The document stays as it is.
class JobPreview final : public QObject
{
    Q_OBJECT

public:
    JobPreview(Workspace &workspace, ShownMap &shownMap, QObject *parent = nullptr);

    //! Begins to show the maps of a job. \returns what receives them: callable from any thread, also after
    //! end(), which it outlives
    std::function<void(const unwrap::UnwrapResult &)> begin();
    //! Shows the document's map again.
    void end();
    //! True while a map of the job is shown.
    bool isShown() const { return mShown; }

private:
    void show(const UvMatrix &map);

    Workspace &mWorkspace;
    ShownMap &mShownMap;
    Inbox<UvMatrix> mMaps; //!< of the running job
    bool mShown = false;
};

} // namespace autocuts
