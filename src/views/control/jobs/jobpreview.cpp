#include "views/control/jobs/jobpreview.h"

#include "model/document/makesnapshot.h"
#include "model/plain/uvlayout.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"

#include <utility>

namespace autocuts {

JobPreview::JobPreview(Workspace &workspace, ShownMap &shownMap, QObject *parent)
    : QObject(parent), mWorkspace(workspace), mShownMap(shownMap)
{
    connect(&workspace, &Workspace::documentReplaced, this, &JobPreview::end);
}

std::function<void(const unwrap::UnwrapResult &)> JobPreview::begin()
{
    const Document *document = mWorkspace.document();
    // Where the document has a map, that is shown rather than one with too much stretch, or one that does
    // not obey.
    const bool hasMap = document && hasUvs(*document);
    return mMaps.open<unwrap::UnwrapResult>(
        [this](const UvMatrix &map) { show(map); },
        [hasMap](std::optional<UvMatrix> &newest, const unwrap::UnwrapResult &map) {
            if (!hasMap || (map.withinBound && map.unmet.empty()))
                newest = map.uv;
        });
}

void JobPreview::end()
{
    mMaps.close();
    if (std::exchange(mShown, false))
        mShownMap.showDocument();
}

void JobPreview::show(const UvMatrix &map)
{
    const Document *document = mWorkspace.document();
    if (!document || map.rows() != document->mesh().cornerCount())
        return;
    mShown = true;
    mShownMap.showMap(map);
}

} // namespace autocuts
