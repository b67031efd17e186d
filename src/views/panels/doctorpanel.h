// The mesh doctor panel.
#pragma once

#include "views/panels/panel.h"
#include "views/selecting/findings.h"

#include <vector>

class QGridLayout;
class QLabel;

namespace autocuts {

//! Shows what is unusual about the model and how it is handled, the counts of the model, and the figures of
//! the map. A click on the number of something unusual selects it.
class DoctorPanel final : public Panel
{
    Q_OBJECT

public:
    explicit DoctorPanel(const StudioContext &context, QWidget *parent = nullptr);

Q_SIGNALS:
    //! The views should show the newly selected elements.
    void frameSelectionRequested();

protected:
    void refresh() override;

private:
    QWidget *makeCounts();
    QWidget *makeFigures();
    void showNotes(const Document &document);
    void showCounts(const MeshReport &report);
    void showFigures();
    void selectElements(Finding finding);
    //! Makes the number in a label a link that selects what it counts.
    void linkTo(QLabel &label, Finding finding);

    QLabel *mNotes;
    std::vector<QLabel *> mCounts, mFigures; //!< in the order of their rows
};

} // namespace autocuts
