// The status bar of the window.
#pragma once

#include "views/control/session/studiocontext.h"

#include <QStatusBar>
#include <QTimer>

class QLabel;
class QProgressBar;
class QToolButton;

namespace autocuts {

class ElidedLabel;
class FigureStrip;
class JobRunner;

//! Shows the hint of the tool, the active one of several UV sets, the number of selected elements, figures of
//! the solver and the map, and the running job. Texts are shortened when the window is narrow; figures keep
//! their positions.
class StatusBar final : public QStatusBar
{
    Q_OBJECT

public:
    //! The figures in the order of figures(); the last ones are hidden first when there is no room.
    enum Figure {
        Distortion,
        SeamLength,
        Islands,
        Flips,
        Overlaps,
        Lambda,
        Delta,
        Energy,
        Separation,
        Steps,
        FigureCount
    };

    explicit StatusBar(const StudioContext &context, QWidget *parent = nullptr);

    //! Shows what the tool does and with which keys. \param hint translated
    void setHint(const QString &hint);
    //! Shows a message instead of the hint.
    //! \param timeoutMs after this time the hint returns; 0: at the next message
    void showText(const QString &message, int timeoutMs = 8000);
    //! The text at the left: a message, a job or the hint.
    QString shownText() const;
    //! The text about the selection.
    QString selectionText() const;
    //! Which UV set is edited; empty where there is no choice.
    QString setText() const;
    //! The figures of the solver and the map.
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
    void showSelection();
    //! The running job; null when there is none.
    JobRunner *runningJob() const;

    StudioContext mContext;
    QString mHint, mMessage;
    QTimer mMessageTimer, mRefreshTimer;
    QTimer mIslandsRest;  //!< runs while the map is being edited
    QTimer mLoadingTimer; //!< runs while nothing is said yet of textures that are being read
    bool mLoadingLong = false;
    bool mSelectionStale = true;
    ElidedLabel *mText, *mSet, *mSelection;
    QLabel *mOfSoup; //!< says that the figures behind it are those of the soup
    FigureStrip *mFigures;
    QProgressBar *mProgress;
    QToolButton *mCancel;
};

//! The number and size of the selected elements, such as "12 faces, area 3.4"; empty when nothing is
//! selected.
QString selectionSummary(const class Document &document);

} // namespace autocuts
