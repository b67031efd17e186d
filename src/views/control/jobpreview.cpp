#include "views/control/jobpreview.h"

#include "model/document/makesnapshot.h"
#include "model/plain/uvlayout.h"
#include "views/control/shownmap.h"
#include "views/control/workspace.h"

#include <QMetaObject>

#include <mutex>
#include <optional>
#include <utility>

namespace autocuts {

//! The newest map of one job, on its way to the GUI thread.
class JobPreview::Box final
{
public:
    //! \param hasMap the document has a map, which is shown rather than one with too much stretch, or one
    //! that does not obey
    Box(JobPreview &preview, bool hasMap) : mPreview(&preview), mHasMap(hasMap) {}

    //! Called on the job's thread.
    void put(const unwrap::UnwrapResult &map)
    {
        const std::scoped_lock lock(mMutex);
        if (!mPreview || (mHasMap && (!map.withinBound || !map.unmet.empty())))
            return;
        // One call is enough for all maps that come before it.
        if (!mMap)
            QMetaObject::invokeMethod(mPreview, &JobPreview::show, Qt::QueuedConnection);
        mMap = map.uv;
    }
    //! Nothing when it was taken already.
    std::optional<UvMatrix> take()
    {
        const std::scoped_lock lock(mMutex);
        return std::exchange(mMap, {});
    }
    //! Later maps are dropped.
    void close()
    {
        const std::scoped_lock lock(mMutex);
        mPreview = nullptr;
    }

private:
    std::mutex mMutex;
    JobPreview *mPreview;
    bool mHasMap;
    std::optional<UvMatrix> mMap;
};

JobPreview::JobPreview(Workspace &workspace, ShownMap &shownMap, QObject *parent)
    : QObject(parent), mWorkspace(workspace), mShownMap(shownMap)
{
    connect(&workspace, &Workspace::documentReplaced, this, &JobPreview::end);
}

JobPreview::~JobPreview()
{
    if (mBox)
        mBox->close();
}

std::function<void(const unwrap::UnwrapResult &)> JobPreview::begin()
{
    if (mBox)
        mBox->close();
    const Document *document = mWorkspace.document();
    mBox = std::make_shared<Box>(*this, document && hasUvs(*document));
    return [box = mBox](const unwrap::UnwrapResult &map) { box->put(map); };
}

void JobPreview::end()
{
    if (!mBox)
        return;
    mBox->close();
    mBox.reset();
    if (std::exchange(mShown, false))
        mShownMap.showDocument();
}

void JobPreview::show()
{
    const auto map = mBox ? mBox->take() : std::nullopt;
    const Document *document = mWorkspace.document();
    if (!map || !document || map->rows() != document->mesh().cornerCount())
        return;
    mShown = true;
    mShownMap.showMap(*map);
}

} // namespace autocuts
