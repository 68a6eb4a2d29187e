#include "bentur/solve/engine/run/watch/relation_group.h"

#include <limits>
#include <utility>

namespace bentur::engine {

using Eigen::Index;
using Eigen::VectorXd;

bool RelationGroup::look(const double* q, const double* q_end, const double* rise) {
  reach.setConstant(std::numeric_limits<double>::infinity());
  return rows.settled(q + begin, q_end + begin, rise + begin, reach.data(), reach.data());
}

std::vector<RelationGroup> relation_groups(const std::vector<Bounded>& relations) {
  std::vector<RelationGroup> groups;
  const auto alike = [&](Index i, Index j) {
    const ModalSystem::Relation& one = *relations[i].relation;
    const ModalSystem::Relation& other = *relations[j].relation;
    return one.left_begin == other.left_begin && one.right_begin == other.right_begin &&
           relations[i].of == relations[j].of && relations[i].switched == relations[j].switched;
  };
  for (Index first = 0, end = 0; first < std::ssize(relations); first = end) {
    while (end < std::ssize(relations) && alike(first, end)) ++end;
    const ModalSystem::Relation& of = *relations[first].relation;
    const Index columns = of.right_size > 0 ? of.right_begin + of.right_size - of.left_begin : of.left_size;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(end - first, columns);
    for (Index i = first; i < end; ++i) {
      const auto& [relation, sign, kind, switched] = relations[i];
      matrix.row(i - first).head(relation->left_size) = sign * relation->left_row.transpose();
      matrix.row(i - first).tail(relation->right_size) += sign * relation->right_row.transpose();
    }
    BoundedOutputs rows(matrix, columns, relations[first].of);
    const VectorXd reach = VectorXd::Zero(rows.size());
    groups.push_back({first, end - first, of.left_begin, std::move(rows), reach});
  }
  return groups;
}

std::vector<RelationGroup> relation_groups(const std::vector<ModalSystem::Relation>& relations) {
  std::vector<Bounded> all;
  for (const ModalSystem::Relation& relation : relations) all.push_back({&relation});
  return relation_groups(all);
}

}  // namespace bentur::engine
