//! Which of a file's animations is read.

use crate::assumption::Assumption;
use effigy_core::io::file::{FormatError, excerpt};

/// Animations that an error or assumption names.
const NAMED: usize = 20;

/// The animation that is read where none is asked for.
pub struct Usual {
    pub index: usize,
    /// Which one it is, for messages.
    pub what: &'static str,
}

impl Usual {
    /// The index of the animation that is `asked` for, by name or by number, or else the usual one.
    /// `names`: those of all that there are.
    ///
    /// # Errors
    /// When there is no such animation.
    pub fn or(
        self,
        asked: Option<&str>,
        names: &[Option<&str>],
        assumptions: &mut Vec<Assumption>,
    ) -> Result<usize, FormatError> {
        let name = |at: usize| match names[at] {
            Some(name) => format!("`{}`", excerpt(name)),
            None => format!("number {at}"),
        };
        let mut named: Vec<String> = (0..names.len().min(NAMED)).map(name).collect();
        if names.len() > NAMED {
            named.push(format!("{} more", names.len() - NAMED));
        }
        let named = named.join(", ");
        let found = match asked {
            None => Some(self.index),
            Some(_) => {
                let by_name = names.iter().position(|name| *name == asked);
                by_name.or_else(|| asked?.parse().ok())
            }
        };
        let Some(found) = found.filter(|&found| found < names.len()) else {
            let (found, expected) = match asked {
                Some(asked) if !names.is_empty() => (
                    format!("no animation `{}`", excerpt(asked)),
                    format!("one of {named}"),
                ),
                _ => ("no animation".into(), "at least one".into()),
            };
            return Err(FormatError::metadata("animations", found, expected));
        };
        if asked.is_none() && names.len() > 1 {
            assumptions.push(Assumption {
                what: "animation",
                taken: name(found),
                because: format!("it is {} of {named}", self.what),
            });
        }
        Ok(found)
    }
}
