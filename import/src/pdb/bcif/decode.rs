//! Encoded columns of BinaryCIF (D. Sehnal and others, "BinaryCIF and CIFTools", PLoS Comput. Biol. 2020), version 0.3.

use rmpv::ValueRef;
use std::fmt::Write;

/// A column's values, without its mask.
pub enum Values<'a> {
    Whole(Vec<i64>),
    Numbers(Vec<f64>),
    /// Texts, and which of them each row has; a negative one is no text.
    Texts(Vec<&'a str>, Vec<i64>),
}

/// What is read, or what is wrong with it.
pub type Read<T> = Result<T, String>;

/// Values that may still be decoded: a short file must not fill the memory.
pub struct Budget(pub usize);

impl Budget {
    fn take(&mut self, count: usize) -> Read<()> {
        let rest = self.0.checked_sub(count);
        self.0 = rest.ok_or("it holds more values than a file of its size can")?;
        Ok(())
    }

    fn count(&mut self, map: &ValueRef, key: &str) -> Read<usize> {
        let count = usize::try_from(whole(map, key)?);
        let count = count.map_err(|_| format!("its `{key}` is negative"))?;
        self.take(count)?;
        Ok(count)
    }

    /// Decodes `data`: its bytes went through the encodings from the first to the last, and come back the other way.
    pub fn decode<'a>(&mut self, data: &ValueRef<'a>) -> Read<Values<'a>> {
        self.chain(get(data, "data")?, array(get(data, "encoding")?)?)
    }

    fn chain<'a>(&mut self, bytes: &ValueRef<'a>, encodings: &[ValueRef<'a>]) -> Read<Values<'a>> {
        let ValueRef::Binary(bytes) = bytes else {
            return Err("its bytes are missing".to_owned());
        };
        let (last, before) = encodings.split_last().ok_or("it has no encoding")?;
        let mut values = match text(get(last, "kind")?)? {
            "ByteArray" => self.byte_array(bytes, whole(last, "type")?)?,
            "StringArray" => self.string_array(bytes, last)?,
            other => return Err(format!("its last encoding is `{other}`")),
        };
        for encoding in before.iter().rev() {
            let kind = text(get(encoding, "kind")?)?;
            let Values::Whole(numbers) = values else {
                return Err(format!("its encoding `{kind}` is not of whole numbers"));
            };
            values = match kind {
                "FixedPoint" => match number(encoding, "factor")? {
                    0.0 => return Err("its `factor` is zero".to_owned()),
                    factor => Values::Numbers(numbers.iter().map(|n| *n as f64 / factor).collect()),
                },
                "IntervalQuantization" => Values::Numbers(interval(&numbers, encoding)?),
                "RunLength" => {
                    Values::Whole(run_length(&numbers, self.count(encoding, "srcSize")?)?)
                }
                "Delta" => Values::Whole(delta(&numbers, whole(encoding, "origin")?)),
                "IntegerPacking" => Values::Whole(self.packed(&numbers, encoding)?),
                other => return Err(format!("its encoding `{other}` is not known")),
            };
        }
        Ok(values)
    }

    fn each<const N: usize, T>(
        &mut self,
        bytes: &[u8],
        value: impl Fn([u8; N]) -> T,
    ) -> Read<Vec<T>> {
        let (chunks, rest) = bytes.as_chunks::<N>();
        if !rest.is_empty() {
            return Err(format!("its bytes are no multiple of {N}"));
        }
        self.take(chunks.len())?;
        Ok(chunks.iter().map(|c| value(*c)).collect())
    }

    fn byte_array<'a>(&mut self, bytes: &[u8], kind: i64) -> Read<Values<'a>> {
        // The shortest decimal that a short number can be, as its writer meant it.
        let short = |bytes| {
            let text = f32::from_le_bytes(bytes).to_string();
            text.parse().unwrap_or(f64::NAN)
        };
        Ok(match kind {
            1 => Values::Whole(self.each(bytes, |b| i64::from(i8::from_le_bytes(b)))?),
            2 => Values::Whole(self.each(bytes, |b| i64::from(i16::from_le_bytes(b)))?),
            3 => Values::Whole(self.each(bytes, |b| i64::from(i32::from_le_bytes(b)))?),
            4 => Values::Whole(self.each(bytes, |b| i64::from(u8::from_le_bytes(b)))?),
            5 => Values::Whole(self.each(bytes, |b| i64::from(u16::from_le_bytes(b)))?),
            6 => Values::Whole(self.each(bytes, |b| i64::from(u32::from_le_bytes(b)))?),
            32 => Values::Numbers(self.each(bytes, short)?),
            33 => Values::Numbers(self.each(bytes, f64::from_le_bytes)?),
            other => return Err(format!("its type {other} is not known")),
        })
    }

    fn string_array<'a>(&mut self, bytes: &[u8], encoding: &ValueRef<'a>) -> Read<Values<'a>> {
        let all = text(get(encoding, "stringData")?)?;
        let mut decoded = |bytes: &_, key| self.chain(bytes, array(get(encoding, key)?)?);
        let offsets = decoded(get(encoding, "offsets")?, "offsetEncoding")?;
        let places = decoded(&ValueRef::Binary(bytes), "dataEncoding")?;
        let (Values::Whole(offsets), Values::Whole(places)) = (offsets, places) else {
            return Err("its texts have no whole offsets".to_owned());
        };
        let text = |pair: &[i64]| {
            let [from, to] = [pair[0], pair[1]].map(|offset| usize::try_from(offset).ok());
            all.get(from?..to?)
        };
        let texts: Option<Vec<&str>> = offsets.windows(2).map(text).collect();
        let texts = texts.ok_or("its texts have wrong offsets")?;
        Ok(Values::Texts(texts, places))
    }

    /// Small numbers; the least and the greatest of their size say that the next one is added.
    fn packed(&mut self, numbers: &[i64], encoding: &ValueRef) -> Read<Vec<i64>> {
        let is_unsigned = matches!(get(encoding, "isUnsigned")?, ValueRef::Boolean(true));
        let size = self.count(encoding, "srcSize")?;
        let ends = match (whole(encoding, "byteCount")?, is_unsigned) {
            (1, true) => [i64::MIN, 0xff],
            (1, false) => [-0x80, 0x7f],
            (2, true) => [i64::MIN, 0xffff],
            (2, false) => [-0x8000, 0x7fff],
            (other, _) => return Err(format!("its `byteCount` is {other}")),
        };
        let mut values = Vec::with_capacity(size.min(numbers.len()));
        let mut sum = 0i64;
        for number in numbers {
            sum = sum.wrapping_add(*number);
            if !ends.contains(number) {
                values.push(sum);
                sum = 0;
            }
        }
        Ok(values)
    }
}

impl Values<'_> {
    pub fn len(&self) -> usize {
        match self {
            Values::Whole(values) => values.len(),
            Values::Numbers(values) => values.len(),
            Values::Texts(_, places) => places.len(),
        }
    }

    /// Writes the text of a value into an empty string.
    pub fn write(&self, row: usize, text: &mut String) {
        let written = match self {
            Values::Whole(values) => write!(text, "{}", values[row]),
            Values::Numbers(values) => write!(text, "{}", values[row]),
            Values::Texts(texts, places) => {
                let found = usize::try_from(places[row]).ok().and_then(|k| texts.get(k));
                text.write_str(found.copied().unwrap_or_default())
            }
        };
        written.expect("a string takes any text");
    }
}

pub fn get<'a, 'v>(map: &'v ValueRef<'a>, key: &str) -> Read<&'v ValueRef<'a>> {
    let found = match map {
        ValueRef::Map(pairs) => pairs.iter().find(|(name, _)| text(name) == Ok(key)),
        _ => None,
    };
    let value = found.map(|(_, value)| value);
    value.ok_or_else(|| format!("it has no `{key}`"))
}

pub fn text<'a>(value: &ValueRef<'a>) -> Read<&'a str> {
    let text = match value {
        ValueRef::String(text) => text.into_str(),
        _ => None,
    };
    text.ok_or_else(|| "a text is missing".to_owned())
}

pub fn array<'a, 'v>(value: &'v ValueRef<'a>) -> Read<&'v [ValueRef<'a>]> {
    match value {
        ValueRef::Array(members) => Ok(members),
        _ => Err("an array is missing".to_owned()),
    }
}

fn number(map: &ValueRef, key: &str) -> Read<f64> {
    let value = match get(map, key)? {
        ValueRef::Integer(whole) => whole.as_f64(),
        ValueRef::F32(value) => Some(f64::from(*value)),
        ValueRef::F64(value) => Some(*value),
        _ => None,
    };
    let value = value.filter(|v| v.is_finite());
    value.ok_or_else(|| format!("its `{key}` is no number"))
}

fn whole(map: &ValueRef, key: &str) -> Read<i64> {
    let value = number(map, key)?;
    let is_whole = value.fract() == 0.0 && value.abs() < 1e15;
    let value = is_whole.then_some(value as i64);
    value.ok_or_else(|| format!("its `{key}` is no whole number"))
}

fn interval(numbers: &[i64], encoding: &ValueRef) -> Read<Vec<f64>> {
    let (low, high) = (number(encoding, "min")?, number(encoding, "max")?);
    let step = match whole(encoding, "numSteps")? as f64 - 1.0 {
        steps if steps > 0.0 => (high - low) / steps,
        _ => 0.0,
    };
    Ok(numbers.iter().map(|n| low + step * *n as f64).collect())
}

fn run_length(numbers: &[i64], size: usize) -> Read<Vec<i64>> {
    let mut values = Vec::with_capacity(size);
    for pair in numbers.chunks(2) {
        let [value, times] = *pair else {
            return Err("its last run has no length".to_owned());
        };
        let times = usize::try_from(times).ok();
        let times = times.filter(|times| *times <= size - values.len());
        let times = times.ok_or("its runs are longer than it")?;
        values.extend(std::iter::repeat_n(value, times));
    }
    Ok(values)
}

fn delta(numbers: &[i64], mut sum: i64) -> Vec<i64> {
    let add = |n: &i64| {
        sum = sum.wrapping_add(*n);
        sum
    };
    numbers.iter().map(add).collect()
}
