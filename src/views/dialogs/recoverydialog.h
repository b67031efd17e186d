// The dialog for recovering sessions after a crash.
#pragma once

#include "model/io/projects/autosave.h"

#include <QDialog>

#include <vector>

class QPushButton;
class QTreeWidget;

namespace autocuts {

class Questions;

//! Lists sessions that did not end normally. One can be recovered now; others can be discarded or kept for
//! later.
class RecoveryDialog final : public QDialog
{
    Q_OBJECT

public:
    //! \pre sessions is not empty
    RecoveryDialog(std::vector<RecoverableSession> sessions, Questions &questions);

    //! The session to recover. \pre the dialog was accepted
    const RecoverableSession &chosen() const { return mSessions[currentRow()]; }
    int count() const { return static_cast<int>(mSessions.size()); }

private:
    void fill();
    void discard();
    int currentRow() const;

    std::vector<RecoverableSession> mSessions;
    Questions &mQuestions;
    QTreeWidget *mList;
    QPushButton *mRecover, *mDiscard;
};

} // namespace autocuts
