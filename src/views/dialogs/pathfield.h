// A field for the path of a file to write.
#pragma once

#include <QStringList>
#include <QWidget>

class QLineEdit;

namespace autocuts {

class Questions;

//! A path and a button that opens a file dialog.
class PathField final : public QWidget
{
    Q_OBJECT

public:
    //! \param title title of the file dialog
    PathField(const QString &title, Questions &questions, QWidget *parent = nullptr);

    QString path() const;
    void setPath(const QString &path);
    //! Replaces the suffix of the path.
    void setSuffix(const QString &suffix);
    //! Filters as for QFileDialog.
    void setFilters(const QStringList &filters) { mFilters = filters; }
    //! What is wrong with the path, translated; empty when a file can be written there.
    QString problem() const;
    //! Asks before replacing a file, unless the user has already agreed.
    bool confirmReplacing();

Q_SIGNALS:
    void pathChanged();

private:
    void browse();

    QString mTitle;
    Questions &mQuestions;
    QStringList mFilters;
    QLineEdit *mEdit;
    QString mAgreed; //!< path that the user agreed to replace
};

} // namespace autocuts
