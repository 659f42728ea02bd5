//! How much is kept of the faults of one file. A stranger's key of any length is part of the
//! pointer of each fault below it: what is beyond the room is counted, and the rules say how many
//! that are.

/// Bytes of faults that are kept: a hundred thousand of usual ones.
const MOST: usize = 8 << 20;
/// What a fault takes besides its pointer.
const OF_EACH: usize = 64;

/// The room for the faults of one file, and how many found none.
#[derive(Debug, Default)]
pub(super) struct Room {
    taken: usize,
    pub(super) left_out: usize,
}

impl Room {
    /// Whether there is room for one more. Behind the first that finds none there is none for any:
    /// those that are kept are the first ones.
    pub(super) const fn takes_one(&mut self) -> bool {
        if self.taken >= MOST {
            self.left_out += 1;
            return false;
        }
        true
    }

    /// Notes the pointer of the one that was kept.
    pub(super) const fn take(&mut self, pointer: &str) {
        self.taken = self.taken.saturating_add(pointer.len() + OF_EACH);
    }
}

#[cfg(test)]
mod tests {
    use crate::{check, parse};

    const LONG: usize = 1 << 20;

    #[test]
    fn a_long_key_is_kept_for_a_few_of_many_faults_and_the_others_are_counted() {
        let long = "k".repeat(LONG);
        let many = |part: &str| vec![part; 100].join(",");
        let twice = parse(format!("{{\"{long}\": {{{}}}}}", many("\"a\": 1")).as_bytes()).unwrap();
        assert_eq!((twice.duplicates.len(), twice.duplicates_left_out), (8, 91));
        let numbers =
            parse(format!("{{\"{long}\": {{\"barycentric\": [{}]}}}}", many("1")).as_bytes())
                .unwrap();
        let found = check("modelling", &numbers);
        assert_eq!((found.faults.len(), found.faults_left_out), (8, 92));
        assert!(
            found
                .faults
                .iter()
                .all(|fault| numbers.at(&fault.pointer).is_some() && fault.pointer.len() > LONG)
        );
        let keys: Vec<String> = (0..100).map(|number| format!("\"q{number}\": 1")).collect();
        let unknown = parse(format!("{{\"{long}\": {{{}}}}}", keys.join(",")).as_bytes()).unwrap();
        let found = check("modelling", &unknown);
        assert_eq!((found.unknown.len(), found.unknown_left_out), (8, 92));
    }

    #[test]
    fn usual_faults_are_all_kept() {
        let text = format!(
            "{{\"A\": {{\"barycentric\": [{}]}}}}",
            vec!["1"; 50_000].join(",")
        );
        let found = check("modelling", &parse(text.as_bytes()).unwrap());
        assert_eq!((found.faults.len(), found.faults_left_out), (50_000, 0));
    }
}
