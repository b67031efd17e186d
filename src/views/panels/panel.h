// The base class of all docked panels.
#pragma once

#include "commands/documentcommand.h"
#include "views/control/session/studiocontext.h"

#include <QTimer>
#include <QWidget>

class QLabel;
class QScrollArea;

namespace autocuts {

//! A panel scrolls when its dock is too small. While nothing is open it is disabled and shows an explanation.
//! It refreshes at most once per turn of the event loop, and only while it is visible.
class Panel : public QWidget
{
    Q_OBJECT

public:
    ~Panel() override;

    //! True when no refresh is pending.
    bool isUpToDate() const { return !mStale; }

protected:
    //! \param emptyText text that is shown while nothing is open
    Panel(const StudioContext &context, const QString &emptyText, QWidget *parent);

    //! The widget to which subclasses add their controls.
    QWidget *content() const { return mContent; }
    const StudioContext &context() const { return mContext; }
    //! The open document; null when nothing is open.
    Document *document() const;

    //! Updates the widgets from the document. Also called when no document is open.
    virtual void refresh() = 0;
    //! Requests a refresh. \param delayMs time without further requests before it
    void refreshSoon(int delayMs = 0);

    //! Changes the solver's settings by one command. \param edit changes the settings that it is given
    template <class Edit>
    void changeSolveSettings(Edit edit, quint64 gesture = 0)
    {
        if (!document())
            return;
        SolveSettings settings = document()->solveSettings();
        edit(settings);
        pushSettings(settings, document()->packingSettings(), gesture);
    }
    //! Changes the packing settings by one command. \param edit changes the settings that it is given
    template <class Edit>
    void changePackingSettings(Edit edit, quint64 gesture = 0)
    {
        if (!document())
            return;
        PackingSettings settings = document()->packingSettings();
        edit(settings);
        pushSettings(document()->solveSettings(), settings, gesture);
    }
    //! The gesture number for a change by a control. \param first true makes a new number
    quint64 gestureFor(bool first);

    //! Adds the current shortcuts of the actions to a widget's tooltip and keeps them up to date. A button
    //! also gets the icon of the first action. \pre the ids are in actionTable()
    void explain(QWidget *widget, const QString &tip, std::initializer_list<const char *> actionIds);

    void showEvent(QShowEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    int neededWidth() const;
    void showWhetherEmpty();
    void refreshNow();
    void pushSettings(const SolveSettings &solve, const PackingSettings &packing, quint64 gesture);

    StudioContext mContext;
    QLabel *mEmptyNote;
    QScrollArea *mScrollArea;
    QWidget *mContent;
    QTimer mRefreshTimer;
    quint64 mGesture = 0, mScrub = 0;
    bool mStale = true;
};

} // namespace autocuts
