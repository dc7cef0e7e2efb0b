// SPDX-License-Identifier: MIT
// What scripts/check build takes as the measure of a machine and compiler: templates to instantiate and loops to
// optimise, of packages that the project needs, and no file of the project. A change of it requires another budget.
#include <Eigen/Dense>
#include <algorithm>
#include <map>
#include <string>
#include <vector>

double determinant(const std::vector<double>& entries, int n) {
  return Eigen::Map<const Eigen::MatrixXd>(entries.data(), n, n).fullPivLu().determinant();
}

std::vector<std::string> frequent_words(const std::vector<std::string>& text) {
  std::map<std::string, int> count;
  for (const std::string& word : text) ++count[word];
  std::vector<std::string> words;
  for (const auto& [word, times] : count) words.push_back(word);
  std::stable_sort(words.begin(), words.end(), [&](const auto& a, const auto& b) { return count[a] > count[b]; });
  return words;
}
