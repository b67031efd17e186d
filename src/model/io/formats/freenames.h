// Names that nothing else has: programs find bones and what is animated by them.
#pragma once

#include <map>
#include <set>
#include <string>

namespace autocuts {

class FreeNames
{
public:
    //! Takes a name as it is. \returns false when it is taken
    bool take(const std::string &name) { return mTaken.insert(name).second; }
    //! Takes a name, or the name with the next number behind it that is free: NAME_2, NAME_3, ...
    std::string takeFree(const std::string &wanted)
    {
        if (take(wanted))
            return wanted;
        int &number = mNumber.try_emplace(wanted, 1).first->second;
        std::string name;
        do
            name = wanted + '_' + std::to_string(++number);
        while (!take(name));
        return name;
    }

private:
    std::set<std::string> mTaken;
    std::map<std::string, int> mNumber; //!< per name: the last one behind it
};

} // namespace autocuts
