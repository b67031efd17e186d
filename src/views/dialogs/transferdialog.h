// The dialog that asks where UVs are to come from.
#pragma once

#include "jobs/transferchoice.h"

#include <QDialog>

class QCheckBox;
class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace autocuts {

class Document;
class Questions;

//! Asks for a file, a UV set or an object, and how faces are matched.
class TransferDialog final : public QDialog
{
    Q_OBJECT

public:
    //! \param last what was chosen last time
    //! \param folder where Browse begins
    TransferDialog(const Document &document, const jobs::TransferChoice &last, const QString &folder,
                   const QStringList &filters, Questions &questions);

    jobs::TransferChoice choice() const;

private:
    void addSources(const Document &document);
    void browse();
    void showSource();
    QString problem() const;

    Questions &mQuestions;
    QString mFolder;
    QStringList mFilters;
    QComboBox *mFrom, *mUvSet, *mObject, *mMatch;
    QWidget *mFileRow;
    QLineEdit *mPath;
    QCheckBox *mOnlySelection;
    QLabel *mProblem;
    QPushButton *mTransfer;
};

} // namespace autocuts
