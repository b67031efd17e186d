// The mesh doctor panel.
#pragma once

#include "views/panels/panel.h"

#include <vector>

class QGridLayout;
class QLabel;
class QPushButton;

namespace autocuts {

//! Shows what is unusual about the model and how it is handled, the counts of the model, and the figures of
//! the map.
class DoctorPanel final : public Panel
{
    Q_OBJECT

public:
    explicit DoctorPanel(const StudioContext &context, QWidget *parent = nullptr);

protected:
    void refresh() override;

private:
    QWidget *makeCounts();
    QWidget *makeFigures();
    void showNotes(const Document &document);
    void showCounts(const MeshReport &report);
    void showFigures();
    void selectSelfContacts();

    QLabel *mNotes;
    QPushButton *mSelect;                    //!< selects the polygons that meet themselves
    std::vector<QLabel *> mCounts, mFigures; //!< in the order of their rows
};

} // namespace autocuts
