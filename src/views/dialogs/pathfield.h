// A file to write: a path to type, or to choose.
#pragma once

#include <QStringList>
#include <QWidget>

class QLineEdit;

namespace autocuts {

class Questions;

//! A path and a button that asks for one.
class PathField final : public QWidget
{
    Q_OBJECT

public:
    //! \param title of the file dialog
    PathField(const QString &title, Questions &questions, QWidget *parent = nullptr);

    QString path() const;
    void setPath(const QString &path);
    //! Replaces the suffix of the path.
    void setSuffix(const QString &suffix);
    //! As QFileDialog's.
    void setFilters(const QStringList &filters) { mFilters = filters; }
    //! What is wrong with the path, translated; empty when a file can be written there.
    QString problem() const;
    //! Asks before a file is replaced that the user has not agreed to replace yet.
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
