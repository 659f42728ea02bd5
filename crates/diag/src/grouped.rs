//! Values by key.

use std::borrow::Borrow;
use std::cmp::Ordering;

/// Values by key, the keys in order and the values of each in theirs.
///
/// A sorted list: it is asked for with a type of its own at more than a hundred places, and a tree
/// for each of them would be a quarter of all that the compiler translates.
#[derive(Debug, Clone)]
pub struct Grouped<K, V>(Vec<(K, Vec<V>)>);

/// The values of each key, in their order.
pub fn grouped<K: Ord, V>(pairs: impl IntoIterator<Item = (K, V)>) -> Grouped<K, V> {
    let mut pairs: Vec<Option<(K, V)>> = pairs.into_iter().map(Some).collect();
    let key = |at: usize| pairs.get(at).and_then(Option::as_ref).map(|(key, _)| key);
    let order = ordered(pairs.len(), &|one, other| key(one).cmp(&key(other)));
    let mut groups: Vec<(K, Vec<V>)> = Vec::new();
    for at in order {
        let Some((key, value)) = pairs.get_mut(at).and_then(Option::take) else {
            continue;
        };
        match groups.last_mut() {
            Some((last, values)) if *last == key => values.push(value),
            _ => groups.push((key, vec![value])),
        }
    }
    Grouped(groups)
}

/// Numbers up to a count in an order; equal ones stay as they are.
fn ordered(count: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut all: Vec<usize> = (0..count).collect();
    all.sort_by(|one, other| compare(*one, *other));
    all
}

impl<K, V> Default for Grouped<K, V> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<K, V> Grouped<K, V> {
    /// The values of a key.
    pub fn get<Q: Ord + ?Sized>(&self, key: &Q) -> Option<&Vec<V>>
    where
        K: Borrow<Q>,
    {
        let at = self
            .0
            .binary_search_by(|(own, _)| own.borrow().cmp(key))
            .ok()?;
        self.0.get(at).map(|(_, values)| values)
    }

    /// Takes the values of a key away: of many it takes its time.
    pub fn remove<Q: Ord + ?Sized>(&mut self, key: &Q) -> Option<Vec<V>>
    where
        K: Borrow<Q>,
    {
        let at = self
            .0
            .binary_search_by(|(own, _)| own.borrow().cmp(key))
            .ok()?;
        Some(self.0.remove(at).1)
    }

    /// Leaves the keys that are wanted.
    pub fn retain(&mut self, mut is_wanted: impl FnMut(&K, &Vec<V>) -> bool) {
        self.0.retain(|(key, values)| is_wanted(key, values));
    }

    /// The values of each key.
    pub fn into_values(self) -> impl Iterator<Item = Vec<V>> {
        self.0.into_iter().map(|(_, values)| values)
    }

    /// The values of each key.
    pub fn values(&self) -> impl Iterator<Item = &Vec<V>> {
        self.0.iter().map(|(_, values)| values)
    }

    /// Keys with their values.
    pub fn iter(&self) -> impl Iterator<Item = (&K, &Vec<V>)> {
        self.0.iter().map(|(key, values)| (key, values))
    }

    /// How many keys there are.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<K, V> IntoIterator for Grouped<K, V> {
    type Item = (K, Vec<V>);
    type IntoIter = std::vec::IntoIter<(K, Vec<V>)>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter()
    }
}
