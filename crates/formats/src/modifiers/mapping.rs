//! `mh_1-0_modifier_mapping.csv` of MakeHuman 1: what modifiers of models of version 1.0 are called
//! today (`docs/loaders/makehuman1/modifiers.md#shipped-modifiers`).

/// The table, without its heading and the rows that separate parts of it.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct ModifierMapping {
    /// Its rows.
    pub rows: Vec<Renamed>,
}

/// A modifier with another name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Renamed {
    /// Its line.
    pub line: u32,
    /// The older name.
    pub old: String,
    /// The name of today.
    pub new: String,
}

/// Rows kept at most; the table of the program has 218.
const MOST: usize = 20_000;

/// Takes the first two fields of each row.
pub fn read(text: &[u8]) -> ModifierMapping {
    let text = String::from_utf8_lossy(text);
    let rows = (1..).zip(text.lines()).skip(1).filter_map(|(line, row)| {
        let mut fields = row.split(',').map(|field| field.trim().trim_matches('"'));
        let (old, new) = (fields.next()?, fields.next()?);
        (!new.is_empty()).then(|| Renamed {
            line,
            old: old.to_owned(),
            new: new.to_owned(),
        })
    });
    ModifierMapping {
        rows: rows.take(MOST).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_without_a_name_separate() {
        let table = read(b"Old,New,Invert\r\na/b,c/d,\n,,\nx\n\"e\",\"f/g\",Yes\n");
        let rows: Vec<_> = table
            .rows
            .iter()
            .map(|row| (row.line, row.old.as_str(), row.new.as_str()))
            .collect();
        assert_eq!(rows, [(2, "a/b", "c/d"), (5, "e", "f/g")]);
    }
}
