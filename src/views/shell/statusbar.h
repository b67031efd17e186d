// The bar at the bottom of the window.
#pragma once

#include "views/control/studiocontext.h"

#include <QStatusBar>
#include <QTimer>

class QProgressBar;
class QToolButton;

namespace autocuts {

class ElidedLabel;
class FigureStrip;
class JobRunner;

//! What the tool does, the numbers of the selection, the state of the solver and of the map, and the job that
//! runs. Texts give way when the window is narrow; numbers stay at their places.
class StatusBar final : public QStatusBar
{
    Q_OBJECT

public:
    //! What figures() shows, in this order; the last ones go first when there is no room.
    enum Figure {
        Steps,
        Energy,
        Distortion,
        Separation,
        Lambda,
        Delta,
        SeamLength,
        Islands,
        Flips,
        Overlaps
    };

    explicit StatusBar(const StudioContext &context, QWidget *parent = nullptr);

    //! What the tool does at the moment, and with which keys. \param hint translated
    void setHint(const QString &hint);
    //! Shows a message in place of the hint. \param timeoutMs after which the hint is back; 0: until then
    //! next message
    void showText(const QString &message, int timeoutMs = 8000);
    //! What stands at the left: a message, a job or the hint.
    QString shownText() const;
    //! The numbers of the selection.
    QString selectionText() const;
    //! The figures of solver and map.
    const FigureStrip &figures() const { return *mFigures; }

private:
    void addFigures();
    void addJob();
    void connectAll();
    void refreshSoon();
    void refresh();
    void showLiveFigures();
    void showMapFigures();
    void showJob();
    void showLeftText();
    //! The job that runs; null when none does.
    JobRunner *runningJob() const;

    StudioContext mContext;
    QString mHint, mMessage;
    QTimer mMessageTimer, mRefreshTimer;
    QTimer mIslandsRest; //!< runs while the map is being edited
    bool mSelectionStale = true;
    ElidedLabel *mText, *mSelection;
    FigureStrip *mFigures;
    QProgressBar *mProgress;
    QToolButton *mCancel;
};

//! The numbers of the document's selection in its mode: "12 faces, area 3.4", empty when nothing is selected.
QString selectionSummary(const class Document &document);

} // namespace autocuts
