//! Facts on weights: faults of single pairs, and the sum of every vertex as the loader forms it
//! (`docs/loaders/makehuman2/weights.md#loading-weights`).
//!
//! Gets the pairs of all bones and the vertex count of the mesh; costs what the pairs are, not the
//! size of the mesh.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use crate::mhw::sums::{Sums, VertexSum};
use crate::mhw::{BoneWeights, Pair};
use mhlint_diag::{Cases, EXAMPLES, Evidence, Few};

/// Entries whose normalised weight is not above this are dropped by the loaders.
pub const THRESHOLD: f32 = 1e-4;
/// A sum this near to 1 is 1: weights are written with three or four decimals and added as float32.
pub(super) const SUM_TOLERANCE: f32 = 1e-4;
/// Up to this a weight above 1 is one of many that were painted without dividing by their sum.
const MISPLACED: f32 = 2.0;
/// A sum this near to 100 is one of weights in per cent.
const PER_CENT_TOLERANCE: f32 = 1.0;
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
    /// How many of them belong to vertices without another kind of weight: the sum is negative as
    /// well, and dividing by it makes shares of them.
    pub negative_alone: u64,
    /// Weights above 1, by more than 0.0001.
    pub above_one: PairTally,
    /// How many of them are the only weight of their vertex, so that dividing by the sum makes them
    /// 1.
    pub above_one_alone: u64,
    /// Those that take more of their vertex than was meant when they are divided by its sum: they
    /// stand among smaller ones, and these are not per cent.
    pub above_others: PairTally,
    /// NaN and infinity.
    pub non_finite: PairTally,
    /// Pairs that normalising leaves at or below [`THRESHOLD`], zero weights included.
    pub below_threshold: PairTally,
    /// What they take from each vertex, as a share of its weight; in the order of the vertices.
    /// Empty without a mesh.
    pub lost: Vec<(u32, f32)>,
    /// A vertex that the bone listed before.
    pub duplicate: PairTally,
    /// Whether all weights together are more than float32 can say: the sum of some vertex may be
    /// infinite.
    pub may_overflow: bool,
    /// Vertices that the mesh does not have, negative ones included.
    pub out_of_range: PairTally,
    /// How many of them are negative.
    pub negative_index: u64,
    /// How many of them do not fit into 31 bits.
    pub huge_index: u64,
    /// Vertices of the mesh; none without one.
    pub vertices: usize,
    /// What the sums over all bones look like, float32 as in the loader. Empty without a mesh.
    pub sum: SumFacts,
    /// Whether a key occurs twice; the schema reader, which is then asked, knows the places.
    pub has_duplicate_keys: bool,
}

/// Facts on the sums of the vertices.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct SumFacts {
    /// Vertices whose sum is not exactly 0, or that have a faulty entry. All others may be far more
    /// than the file has entries.
    pub reached: Vec<u32>,
    /// Vertices whose sum is not 1, without those that are unweighted or have a faulty entry.
    pub off: u64,
    /// How many of them are off by more than the [`FAR_SUMS`].
    pub far_off: [u64; 2],
    /// Smallest and largest of their sums.
    pub range: (f32, f32),
    /// All of them with their sums, in order.
    pub vertices: Vec<(u32, f32)>,
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
            self.first
                .push((Arc::clone(bone), pair.position, pair.vertex, pair.weight));
        }
        self.names
            .add_long(bone.len(), || format!("{bone}[{}]", pair.vertex));
        let farther = |worst: &(Arc<str>, i64, f32)| pair.weight.abs() > worst.2.abs();
        if self.worst.as_ref().is_none_or(farther) {
            self.worst = Some((Arc::clone(bone), pair.vertex, pair.weight));
        }
    }

    /// As evidence: vertices with their bones as examples.
    pub fn evidence(&self, total: usize) -> Cases {
        let examples = self
            .first
            .iter()
            .map(|(bone, _, vertex, _)| format!("{bone}[{vertex}]"))
            .collect();
        let evidence = Evidence {
            count: self.count,
            of: Some(total as u64),
            examples,
            ..Evidence::default()
        };
        evidence.naming(self.names.names())
    }
}

impl WeightsFacts {
    /// Counts everything. `vertices` is the vertex count of the mesh, if it is known.
    pub(super) fn count(&mut self, bones: &[BoneWeights], vertices: Option<usize>) {
        self.vertices = vertices.unwrap_or(0);
        let mut sums = Sums::of(bones, self.vertices);
        for bone in bones {
            let name = &Arc::from(bone.name.as_str());
            self.count_malformed(bone, name);
            self.pairs += bone.pairs.len();
            for pair in &bone.pairs {
                self.count_pair(name, *pair, vertices.is_some(), &mut sums);
            }
            self.count_duplicates(bone, name, &mut sums);
        }
        let mut lost = BTreeMap::new();
        for bone in bones {
            self.count_below_threshold(bone, &sums, &mut lost);
        }
        self.count_above(bones);
        let all = bones.iter().flat_map(|bone| &bone.pairs);
        self.may_overflow = !all.map(|pair| pair.weight.abs()).sum::<f32>().is_finite();
        self.negative_alone = if self.negative.count > 0 {
            negative_alone(bones)
        } else {
            0
        };
        self.lost = lost.into_iter().collect();
        self.sum = SumFacts::of(&sums);
    }

    fn count_malformed(&mut self, bone: &BoneWeights, name: &Arc<str>) {
        for position in &bone.malformed {
            self.malformed.add(
                name,
                Pair {
                    position: *position,
                    vertex: -1,
                    weight: 0.0,
                },
            );
        }
        let kept = bone.pairs.len() + bone.malformed.len();
        self.malformed.count += bone.listed.saturating_sub(kept) as u64;
    }

    fn count_pair(&mut self, bone: &Arc<str>, pair: Pair, has_mesh: bool, sums: &mut Sums) {
        let tally = match pair.weight {
            weight if !weight.is_finite() => Some(&mut self.non_finite),
            weight if weight < 0.0 => Some(&mut self.negative),
            weight if weight > 1.0 + SUM_TOLERANCE => Some(&mut self.above_one),
            _ => None,
        };
        if let Some(tally) = tally {
            tally.add(bone, pair);
            sums.mark_faulty(&pair);
        }
        let is_in_mesh =
            usize::try_from(pair.vertex).is_ok_and(|vertex| !has_mesh || vertex < self.vertices);
        if !is_in_mesh {
            self.out_of_range.add(bone, pair);
            self.negative_index += u64::from(pair.vertex < 0);
            self.huge_index += u64::from(pair.vertex > i64::from(i32::MAX));
        }
    }

    /// Shipped lists are sorted, which needs no table.
    fn count_duplicates(&mut self, bone: &BoneWeights, name: &Arc<str>, sums: &mut Sums) {
        if bone.pairs.is_sorted_by(|a, b| a.vertex < b.vertex) {
            return;
        }
        let mut seen = BTreeSet::new();
        for pair in &bone.pairs {
            if !seen.insert(pair.vertex) {
                self.duplicate.add(name, *pair);
                sums.mark_faulty(pair);
            }
        }
    }

    /// Needs no mesh: weights of assets are read without one.
    fn count_above(&mut self, bones: &[BoneWeights]) {
        if self.above_one.count == 0 {
            return;
        }
        let mut sums: BTreeMap<i64, f32> = BTreeMap::new();
        for pair in bones.iter().flat_map(|bone| &bone.pairs) {
            *sums.entry(pair.vertex).or_default() += pair.weight;
        }
        let above = |pair: &&Pair| pair.weight.is_finite() && pair.weight > 1.0 + SUM_TOLERANCE;
        for bone in bones {
            let name = &Arc::from(bone.name.as_str());
            for pair in bone.pairs.iter().filter(above) {
                let sum = sums.get(&pair.vertex).copied();
                // Exactly the sum: another weight, however small, has its share of the vertex.
                if sum == Some(pair.weight) {
                    self.above_one_alone += 1;
                } else if pair.weight > MISPLACED
                    && sum.is_none_or(|sum| (sum - 100.0).abs() > PER_CENT_TOLERANCE)
                {
                    self.above_others.add(name, *pair);
                }
            }
        }
    }

    fn count_below_threshold(
        &mut self,
        bone: &BoneWeights,
        sums: &Sums,
        lost: &mut BTreeMap<u32, f32>,
    ) {
        let name = &Arc::from(bone.name.as_str());
        for pair in &bone.pairs {
            let vertex = u32::try_from(pair.vertex).ok();
            let sum = vertex.and_then(|vertex| Some((vertex, sums.of_pair(pair)?)));
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
    let is_alone = |pair: &&Pair| {
        pair.weight < 0.0 && pair.weight.is_finite() && !others.contains(&pair.vertex)
    };
    pairs().filter(is_alone).count() as u64
}

impl SumFacts {
    fn of(sums: &Sums) -> Self {
        let mut facts = Self {
            range: (f32::INFINITY, f32::NEG_INFINITY),
            ..Self::default()
        };
        for VertexSum {
            vertex,
            sum,
            is_faulty,
        } in sums.iter()
        {
            if *sum != 0.0 || *is_faulty {
                facts.reached.push(*vertex);
            }
            if *sum != 0.0 && !is_faulty && (sum - 1.0).abs() > SUM_TOLERANCE {
                facts.add(*vertex, *sum);
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
        self.vertices.push((vertex, sum));
    }
}

#[cfg(test)]
mod tests {
    use super::Sums;
    use crate::mhw::{Pair, Weights, parse};
    use mhlint_source::Encoding;

    fn weights(text: &str, vertices: usize) -> Weights {
        parse(
            text.as_bytes(),
            &Encoding::of(text.as_bytes()),
            Some(vertices),
        )
        .unwrap()
    }

    fn sums(weights: &Weights) -> Vec<f32> {
        Sums::of(&weights.bones, weights.facts.vertices)
            .iter()
            .map(|sum| sum.sum)
            .collect()
    }

    #[test]
    fn pairs_are_sorted_into_their_faults() {
        let text = r#"{"name": "x", "weights": {"a": [[0, 0.5], [0, 0.5], [1, -0.25], [2, 1.5], [4, 1], [-1, 1]],
            "b": [[1, 1], [3, NaN], [2, 0.0001], 7, [1], ["1", 1], [1.0, 1]], "c": []}}"#;
        let weights = weights(text, 4);
        assert_eq!(sums(&weights)[..2], [1.0, 0.75]);
        let f = weights.facts;
        let counts = [
            &f.duplicate,
            &f.negative,
            &f.above_one,
            &f.out_of_range,
            &f.non_finite,
            &f.malformed,
        ];
        assert_eq!(counts.map(|tally| tally.count), [1, 1, 1, 2, 1, 4]);
        assert_eq!(f.below_threshold.first, [("b".into(), 2, 2, 0.0001)]);
        assert_eq!(f.lost, [(2, 0.0001 / 1.5001)]);
        assert_eq!((f.sum.off, f.negative_index), (0, 1));
    }

    #[test]
    fn a_long_bone_is_not_repeated_for_each_of_its_pairs() {
        let pairs: Vec<String> = (1..1000)
            .map(|weight| format!("[0, -{weight}], [1]"))
            .collect();
        let text = format!(
            r#"{{"weights": {{"{}": [{}]}}}}"#,
            "b".repeat(1 << 20),
            pairs.join(", ")
        );
        let facts = weights(&text, 4).facts;
        assert_eq!((facts.negative.count, facts.malformed.count), (999, 999));
        assert_eq!(
            (
                facts.negative.names.names().len(),
                facts.malformed_names.names().len()
            ),
            (0, 0)
        );
        let names: Vec<&str> = facts
            .negative
            .first
            .iter()
            .map(|(bone, ..)| &**bone)
            .collect();
        assert!(
            names.iter().all(|name| name.as_ptr() == names[0].as_ptr()),
            "one for all"
        );
    }

    #[test]
    fn a_negative_weight_is_harmless_where_no_other_is() {
        let text = r#"{"weights": {"a": [[0, -0.5], [1, -0.5], [2, -0.5]], "b": [[1, -0.25], [2, 1], [0, 0]]}}"#;
        let facts = weights(text, 3).facts;
        assert_eq!((facts.negative.count, facts.negative_alone), (4, 3));
    }

    #[test]
    fn a_weight_above_one_is_harmless_alone_and_in_per_cent() {
        let text = r#"{"weights": {"a": [[0, 1.5], [1, 60], [2, 1.25], [3, 50]], "b": [[1, 40.5], [2, 0.5], [3, 0.5]]}}"#;
        let facts = weights(text, 4).facts;
        assert_eq!((facts.above_one.count, facts.above_one_alone), (5, 1));
        assert_eq!(facts.above_others.first, [("a".into(), 3, 3, 50.0)]);
    }

    #[test]
    fn true_and_false_are_weights_and_no_vertices() {
        let weights = weights(
            r#"{"weights": {"a": [[0, true], [1, false], [true, 1]]}}"#,
            2,
        );
        assert_eq!(sums(&weights), [1.0, 0.0]);
        assert_eq!((weights.facts.pairs, weights.facts.malformed.count), (2, 1));
    }

    #[test]
    fn sums_have_a_distribution() {
        let text = r#"{"weights": {"a": [[0, 1], [1, 0.75], [2, 0.995], [3, 0.99995], [5, 0]], "b": [[1, 0.5]]}}"#;
        let facts = weights(text, 6).facts;
        let sum = facts.sum;
        assert_eq!(sum.reached, [0, 1, 2, 3]);
        assert_eq!((sum.off, sum.far_off), (2, [1, 1]));
        assert_eq!(
            (sum.vertices, sum.range),
            (vec![(1, 1.25), (2, 0.995)], (0.995, 1.25))
        );
    }

    #[test]
    fn a_small_file_is_small_whatever_the_mesh() {
        // Nobody has room for a number for each of these vertices.
        let weights = weights(
            r#"{"weights": {"b": [[9, 0.5]], "a": [[9, 0.5], [7, 1], [8, 0]]}}"#,
            1 << 50,
        );
        assert_eq!(
            (sums(&weights), weights.facts.sum.reached),
            (vec![1.0, 0.0, 1.0], vec![7, 9])
        );
    }

    #[test]
    fn weights_of_a_vertex_are_added_in_the_order_of_the_file() {
        let text =
            r#"{"weights": {"b": [[0, 1e8]], "a": [[1, 1], [0, 1]], "c": [[0, -1e8], [0, 0.5]]}}"#;
        let pair = Pair {
            position: 0,
            vertex: 0,
            weight: 0.0,
        };
        assert_eq!(
            Sums::of(&weights(text, 2).bones, 2).of_pair(&pair),
            Some(1e8_f32 + 1.0 - 1e8 + 0.5)
        );
    }
}
