// What all docked panels have in common.
#pragma once

#include "commands/documentcommand.h"
#include "views/control/studiocontext.h"

#include <QTimer>
#include <QWidget>

class QLabel;
class QScrollArea;

namespace autocuts {

//! A panel scrolls when its dock is too small, is disabled with a line of explanation while nothing is open,
//! and refreshes itself at most once per turn of the event loop and only while it is seen.
class Panel : public QWidget
{
    Q_OBJECT

public:
    ~Panel() override;

    //! True when refresh() has nothing to catch up with.
    bool isUpToDate() const { return !mStale; }

protected:
    //! \param emptyText shown while nothing is open
    Panel(const StudioContext &context, const QString &emptyText, QWidget *parent);

    //! The widget that is filled by the panel.
    QWidget *content() const { return mContent; }
    const StudioContext &context() const { return mContext; }
    //! Null when nothing is open.
    Document *document() const;

    //! Brings the widgets in line with the document. Called with and without one.
    virtual void refresh() = 0;
    //! Asks for a refresh. \param delayMs of quiet to wait for
    void refreshSoon(int delayMs = 0);

    //! Changes the solver's settings by one command. \param edit is given the settings to change
    template <class Edit>
    void changeSolveSettings(Edit edit, quint64 gesture = 0)
    {
        if (!document())
            return;
        SolveSettings settings = document()->solveSettings();
        edit(settings);
        pushSettings(settings, document()->packingSettings(), gesture);
    }
    //! Changes the packing settings by one command. \param edit is given the settings to change
    template <class Edit>
    void changePackingSettings(Edit edit, quint64 gesture = 0)
    {
        if (!document())
            return;
        PackingSettings settings = document()->packingSettings();
        edit(settings);
        pushSettings(document()->solveSettings(), settings, gesture);
    }
    //! The number for a change that a control reports. \param first of a gesture: a new number
    quint64 gestureFor(bool first);

    //! Gives a widget a tooltip with the keys of actions, now and whenever those change; a button also gets
    //! the icon of the first one. \pre the ids are in actionTable()
    void explain(QWidget *widget, const QString &tip, std::initializer_list<const char *> actionIds);

    void showEvent(QShowEvent *event) override;

private:
    void showWhetherEmpty();
    void refreshNow();
    void pushSettings(const SolveSettings &solve, const PackingSettings &packing, quint64 gesture);

    StudioContext mContext;
    QLabel *mEmptyNote;
    QScrollArea *mScrollArea;
    QWidget *mContent;
    QTimer mRefreshTimer;
    quint64 mGesture = 0;
    bool mStale = true;
};

} // namespace autocuts
