// The panel of the objects and materials of the model.
#pragma once

#include "views/panels/panel.h"
#include "views/panels/scenetable.h"

class QLabel;
class QLineEdit;
class QMenu;
class QSortFilterProxyModel;
class QTabBar;
class QTableView;

namespace autocuts {

class Questions;

//! A list of the objects or of the materials. Selecting rows selects their faces, or the edges or vertices of
//! these, and vice versa. An eye in each row hides and shows it; a menu starts jobs on the selected rows.
class ScenePanel final : public Panel
{
    Q_OBJECT

public:
    //! \param questions asks over the window; must outlive the panel
    ScenePanel(const StudioContext &context, Questions &questions, QWidget *parent = nullptr);

    //! Rows of the table, ascending.
    std::vector<int> selectedRows() const;

protected:
    void refresh() override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    SceneKind kind() const;
    void makeTabs();
    void makeTable();
    void fitNames();
    QWidget *makeButtons();
    void documentChanged(const ChangeEvent &event);
    void refreshRows();
    void refreshFigures(int delayMs);
    void showSummary();
    void selectRows(const Document &document);
    void selectFaces();
    void selectFaces(SelectionMode mode);
    QList<int> facesOf(const std::vector<int> &rows) const;
    void hide(const QList<int> &faces, bool hide);
    void isolate(const QList<int> &faces);
    void solo(const QList<int> &faces);
    bool pressEye(const QPoint &place, bool alone);
    void fillMenu(QMenu &menu);
    void addJob(QMenu &menu, const char *id);
    void saveFigures();

    Questions &mQuestions;
    SceneTable *mTable;
    QSortFilterProxyModel *mSorted;
    QTabBar *mTabs;
    QLineEdit *mFilter;
    QTableView *mView;
    QLabel *mSummary;
    bool mRowsStale = true; //!< the rows are those of another document or of the other kind
    bool mFiguresStale = true, mHiddenStale = false;
    bool mFitsNames = true; //!< the column of names fits them, until the user changes its width
    bool mFitting = false;  //!< the panel itself is changing that width
    bool mSyncing = false;  //!< rows are being selected after a change of the selection
};

} // namespace autocuts
