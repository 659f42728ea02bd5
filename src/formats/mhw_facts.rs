//! Facts on weights: faults of single pairs, and the sum of every vertex as the loader forms it
//! (formats/makehuman2.md §11).
//!
//! Gets the pairs of all bones and the vertex count of the mesh; one walk, then one over the vertices.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::mhw::{BoneWeights, Pair};
use crate::diag::{Cases, EXAMPLES, Evidence, Few};

/// Entries whose normalised weight is not above this are dropped by the loaders.
pub const THRESHOLD: f32 = 1e-4;
/// A sum this near to 1 is 1: weights are written with three or four decimals and added as float32.
pub(super) const SUM_TOLERANCE: f32 = 1e-4;
/// Distances from 1 that the distribution of sums is counted at.
pub const FAR_SUMS: [f32; 2] = [0.01, 0.1];

/// Facts on a weights file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct WeightsFacts {
    /// Well-formed pairs.
    pub pairs: usize,
    /// Pairs that are not `[integer, number]`.
    pub malformed: PairTally,
    /// What these are known by: the bone and the text of the entry.
    pub malformed_names: Few<String>,
    /// Weights below 0.
    pub negative: PairTally,
    /// How many of them belong to vertices without another kind of weight: the sum is negative as well, and dividing by it
    /// makes shares of them.
    pub negative_alone: u64,
    /// Weights above 1, by more than 0.0001.
    pub above_one: PairTally,
    /// How many of them are the only weight of their vertex, so that dividing by the sum makes them 1.
    pub above_one_alone: u64,
    /// NaN and infinity.
    pub non_finite: PairTally,
    /// Pairs that normalising leaves at or below [`THRESHOLD`], zero weights included.
    pub below_threshold: PairTally,
    /// What they take from each vertex, as a share of its weight; in the order of the vertices. Empty without a mesh.
    pub lost: Vec<(u32, f32)>,
    /// A vertex that the bone listed before.
    pub duplicate: PairTally,
    /// Whether all weights together are more than float32 can say: the sum of some vertex may be infinite.
    pub may_overflow: bool,
    /// Vertices that the mesh does not have, negative ones included.
    pub out_of_range: PairTally,
    /// How many of them are negative.
    pub negative_index: u64,
    /// Sum over all bones per vertex of the mesh, float32 as in the loader. Empty without a mesh.
    pub sums: Vec<f32>,
    /// What the sums look like. Empty without a mesh.
    pub sum: SumFacts,
    /// Whether a key occurs twice; the schema reader, which is then asked, knows the places.
    pub has_duplicate_keys: bool,
}

/// Facts on the sums of the vertices.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SumFacts {
    /// Vertices whose sum is exactly 0: not mentioned, or with zeros only.
    pub unweighted: Vec<u32>,
    /// Vertices whose sum is not 1, without those that are unweighted or have a faulty entry.
    pub off: u64,
    /// How many of them are off by more than the [`FAR_SUMS`].
    pub far_off: [u64; 2],
    /// Smallest and largest of their sums.
    pub range: (f32, f32),
    /// The vertex farthest from 1, and its sum.
    pub worst: Option<(u32, f32)>,
    /// All of them.
    pub vertices: Vec<u32>,
}

/// Counts pairs: how many, the first few as bone and position.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct PairTally {
    /// How many.
    pub count: u64,
    /// The first few: bone, position in its list, vertex, weight.
    pub first: Vec<(Arc<str>, u32, i64, f32)>,
    /// The largest number by amount.
    pub worst: Option<(Arc<str>, i64, f32)>,
    /// All of them as `bone[vertex]`.
    names: Few<String>,
}

impl PairTally {
    fn add(&mut self, bone: &Arc<str>, pair: Pair) {
        self.count += 1;
        if self.first.len() < EXAMPLES {
            self.first.push((Arc::clone(bone), pair.position, pair.vertex, pair.weight));
        }
        self.names.add_long(bone.len(), || format!("{bone}[{}]", pair.vertex));
        let farther = |worst: &(Arc<str>, i64, f32)| pair.weight.abs() > worst.2.abs();
        if self.worst.as_ref().is_none_or(farther) {
            self.worst = Some((Arc::clone(bone), pair.vertex, pair.weight));
        }
    }

    /// As evidence: vertices with their bones as examples.
    pub fn evidence(&self, total: usize) -> Cases {
        let examples = self.first.iter().map(|(bone, _, vertex, _)| format!("{bone}[{vertex}]")).collect();
        let evidence = Evidence { count: self.count, of: Some(total as u64), examples, ..Evidence::default() };
        evidence.naming(self.names.names())
    }
}

impl WeightsFacts {
    /// Counts everything. `vertices` is the vertex count of the mesh, if it is known.
    pub(super) fn count(&mut self, bones: &[BoneWeights], vertices: Option<usize>) {
        self.sums = vec![0.0; vertices.unwrap_or(0)];
        let mut faulty = vec![false; vertices.unwrap_or(0)];
        for bone in bones {
            let name = &Arc::from(bone.name.as_str());
            self.count_malformed(bone, name);
            self.pairs += bone.pairs.len();
            for pair in &bone.pairs {
                self.count_pair(name, *pair, vertices.is_some(), &mut faulty);
            }
            self.count_duplicates(bone, name, &mut faulty);
        }
        let mut lost = BTreeMap::new();
        for bone in bones {
            self.count_alone(bone);
            self.count_below_threshold(bone, &Arc::from(bone.name.as_str()), &mut lost);
        }
        let all = bones.iter().flat_map(|bone| &bone.pairs);
        self.may_overflow = !all.map(|pair| pair.weight.abs()).sum::<f32>().is_finite();
        self.negative_alone = if self.negative.count > 0 { negative_alone(bones) } else { 0 };
        self.lost = lost.into_iter().collect();
        self.sum = SumFacts::of(&self.sums, &faulty);
    }

    fn count_malformed(&mut self, bone: &BoneWeights, name: &Arc<str>) {
        for position in &bone.malformed {
            self.malformed.add(name, Pair { position: *position, vertex: -1, weight: 0.0 });
        }
        let kept = bone.pairs.len() + bone.malformed.len();
        self.malformed.count += bone.listed.saturating_sub(kept) as u64;
    }

    fn count_pair(&mut self, bone: &Arc<str>, pair: Pair, has_mesh: bool, faulty: &mut [bool]) {
        let tally = match pair.weight {
            weight if !weight.is_finite() => Some(&mut self.non_finite),
            weight if weight < 0.0 => Some(&mut self.negative),
            weight if weight > 1.0 + SUM_TOLERANCE => Some(&mut self.above_one),
            _ => None,
        };
        if let Some(tally) = tally {
            tally.add(bone, pair);
            mark(faulty, pair);
        }
        let slot = usize::try_from(pair.vertex).ok().and_then(|vertex| self.sums.get_mut(vertex));
        match slot {
            Some(sum) => *sum += pair.weight,
            None if has_mesh || pair.vertex < 0 => {
                self.out_of_range.add(bone, pair);
                self.negative_index += u64::from(pair.vertex < 0);
            }
            None => {}
        }
    }

    /// Shipped lists are sorted, which needs no table.
    fn count_duplicates(&mut self, bone: &BoneWeights, name: &Arc<str>, faulty: &mut [bool]) {
        if bone.pairs.is_sorted_by(|a, b| a.vertex < b.vertex) {
            return;
        }
        let mut seen = BTreeSet::new();
        for pair in &bone.pairs {
            if !seen.insert(pair.vertex) {
                self.duplicate.add(name, *pair);
                mark(faulty, *pair);
            }
        }
    }

    fn count_alone(&mut self, bone: &BoneWeights) {
        // Exactly the sum: another weight, however small, has its share of the vertex.
        let sum = |pair: &Pair| self.sums.get(usize::try_from(pair.vertex).ok()?).copied();
        let above = bone.pairs.iter().filter(|pair| pair.weight.is_finite() && pair.weight > 1.0 + SUM_TOLERANCE);
        self.above_one_alone += above.filter(|pair| sum(pair) == Some(pair.weight)).count() as u64;
    }

    fn count_below_threshold(&mut self, bone: &BoneWeights, name: &Arc<str>, lost: &mut BTreeMap<u32, f32>) {
        for pair in &bone.pairs {
            let vertex = u32::try_from(pair.vertex).ok();
            let sum = vertex.and_then(|vertex| Some((vertex, *self.sums.get(vertex as usize)?)));
            if let Some((vertex, sum)) = sum
                // Of a sum beyond float32 every share is 0, however large the weight.
                && sum > 0.0
                && sum.is_finite()
                && pair.weight >= 0.0
                && pair.weight / sum <= THRESHOLD
            {
                self.below_threshold.add(name, *pair);
                if pair.weight > 0.0 {
                    *lost.entry(vertex).or_default() += pair.weight / sum;
                }
            }
        }
    }
}

/// Negative weights of vertices that have no weight above 0.
fn negative_alone(bones: &[BoneWeights]) -> u64 {
    let pairs = || bones.iter().flat_map(|bone| &bone.pairs);
    let is_other = |pair: &&Pair| pair.weight > 0.0 || !pair.weight.is_finite();
    let others: BTreeSet<i64> = pairs().filter(is_other).map(|pair| pair.vertex).collect();
    let is_alone = |pair: &&Pair| pair.weight < 0.0 && pair.weight.is_finite() && !others.contains(&pair.vertex);
    pairs().filter(is_alone).count() as u64
}

fn mark(faulty: &mut [bool], pair: Pair) {
    if let Some(faulty) = usize::try_from(pair.vertex).ok().and_then(|vertex| faulty.get_mut(vertex)) {
        *faulty = true;
    }
}

impl SumFacts {
    fn of(sums: &[f32], faulty: &[bool]) -> Self {
        let mut facts = Self { range: (f32::INFINITY, f32::NEG_INFINITY), ..Self::default() };
        for (vertex, (sum, faulty)) in (0u32..).zip(sums.iter().zip(faulty)) {
            if *faulty {
                continue;
            }
            if *sum == 0.0 {
                facts.unweighted.push(vertex);
            } else if (sum - 1.0).abs() > SUM_TOLERANCE {
                facts.add(vertex, *sum);
            }
        }
        facts
    }

    fn add(&mut self, vertex: u32, sum: f32) {
        let deviation = (sum - 1.0).abs();
        self.off += 1;
        for (count, far) in self.far_off.iter_mut().zip(FAR_SUMS) {
            *count += u64::from(deviation > far);
        }
        self.range = (self.range.0.min(sum), self.range.1.max(sum));
        if self.worst.is_none_or(|(_, worst)| deviation > (worst - 1.0).abs()) {
            self.worst = Some((vertex, sum));
        }
        self.vertices.push(vertex);
    }
}

#[cfg(test)]
mod tests {
    use super::super::mhw::{Weights, parse};
    use crate::source::Encoding;

    fn weights(text: &str, vertices: usize) -> Weights {
        parse(text.as_bytes(), &Encoding::of(text.as_bytes()), Some(vertices)).unwrap()
    }

    #[test]
    fn pairs_are_sorted_into_their_faults() {
        let text = r#"{"name": "x", "weights": {"a": [[0, 0.5], [0, 0.5], [1, -0.25], [2, 1.5], [4, 1], [-1, 1]],
            "b": [[1, 1], [3, NaN], [2, 0.0001], 7, [1], ["1", 1], [1.0, 1]], "c": []}}"#;
        let f = weights(text, 4).facts;
        let counts = [&f.duplicate, &f.negative, &f.above_one, &f.out_of_range, &f.non_finite, &f.malformed];
        assert_eq!(counts.map(|tally| tally.count), [1, 1, 1, 2, 1, 4]);
        assert_eq!(f.below_threshold.first, [("b".into(), 2, 2, 0.0001)]);
        assert_eq!(f.lost, [(2, 0.0001 / 1.5001)]);
        assert_eq!((f.sums[0], f.sums[1]), (1.0, 0.75));
        assert_eq!((f.sum.off, f.negative_index), (0, 1));
    }

    #[test]
    fn a_long_bone_is_not_repeated_for_each_of_its_pairs() {
        let pairs: Vec<String> = (1..1000).map(|weight| format!("[0, -{weight}], [1]")).collect();
        let text = format!(r#"{{"weights": {{"{}": [{}]}}}}"#, "b".repeat(1 << 20), pairs.join(", "));
        let facts = weights(&text, 4).facts;
        assert_eq!((facts.negative.count, facts.malformed.count), (999, 999));
        assert_eq!((facts.negative.names.names().len(), facts.malformed_names.names().len()), (0, 0));
        let names: Vec<&str> = facts.negative.first.iter().map(|(bone, ..)| &**bone).collect();
        assert!(names.iter().all(|name| name.as_ptr() == names[0].as_ptr()), "one for all");
    }

    #[test]
    fn a_negative_weight_is_harmless_where_no_other_is() {
        let text = r#"{"weights": {"a": [[0, -0.5], [1, -0.5], [2, -0.5]], "b": [[1, -0.25], [2, 1], [0, 0]]}}"#;
        let facts = weights(text, 3).facts;
        assert_eq!((facts.negative.count, facts.negative_alone), (4, 3));
    }

    #[test]
    fn true_and_false_are_weights_and_no_vertices() {
        let facts = weights(r#"{"weights": {"a": [[0, true], [1, false], [true, 1]]}}"#, 2).facts;
        assert_eq!((facts.pairs, facts.malformed.count, facts.sums), (2, 1, vec![1.0, 0.0]));
    }

    #[test]
    fn sums_have_a_distribution() {
        let text = r#"{"weights": {"a": [[0, 1], [1, 0.75], [2, 0.995], [3, 0.99995], [5, 0]], "b": [[1, 0.5]]}}"#;
        let sum = weights(text, 6).facts.sum;
        assert_eq!((sum.off, sum.far_off, sum.worst), (2, [1, 1], Some((1, 1.25))));
        assert_eq!((sum.unweighted, sum.vertices, sum.range), (vec![4, 5], vec![1, 2], (0.995, 1.25)));
    }
}
