#include "tb/load/column_oracle_impl.h"

namespace rc2::facet {

template class ColumnOracle<std::int64_t>;
template class ColumnOracle<Int128>;

}  // namespace rc2::facet
