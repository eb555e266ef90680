#pragma once
/// All of quadmatch: read, analyse, match, verify, put to use, write.

#include <quadmatch/analysis/anchors.hpp>
#include <quadmatch/analysis/colouring.hpp>
#include <quadmatch/analysis/connectivity_hash.hpp>
#include <quadmatch/analysis/group_order.hpp>
#include <quadmatch/analysis/isomorphism.hpp>
#include <quadmatch/analysis/signature.hpp>
#include <quadmatch/analysis/skeleton.hpp>
#include <quadmatch/analysis/vertex_code.hpp>
#include <quadmatch/io/match_file.hpp>
#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/io/write_mesh.hpp>
#include <quadmatch/match/exact.hpp>
#include <quadmatch/match/matcher.hpp>
#include <quadmatch/match/words.hpp>
#include <quadmatch/mesh/check.hpp>
#include <quadmatch/mesh/components.hpp>
#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/report/report.hpp>
#include <quadmatch/use/diff.hpp>
#include <quadmatch/use/merge.hpp>
#include <quadmatch/use/symmetry.hpp>
#include <quadmatch/use/transfer.hpp>
#include <quadmatch/verify/verify.hpp>
