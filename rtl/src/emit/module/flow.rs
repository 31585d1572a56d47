//! What the statements of a kernel come to: final values of signals, and the branches of registers.

use super::super::EmitError;
use super::super::lower::{Expression, Form, Lowered, Role, Statement};
use std::collections::{BTreeMap, HashMap, HashSet};

/// The statements that assign a wanted target, in their branches.
pub fn filtered(
    statements: &[Statement],
    wanted: &dyn Fn(&str, &Expression) -> bool,
) -> Vec<Statement> {
    let mut kept = Vec::new();
    for statement in statements {
        match statement {
            Statement::Assign(target, value) if wanted(target, value) => {
                kept.push(statement.clone())
            }
            Statement::Assign(..) => {}
            Statement::If(condition, then, otherwise) => {
                let then = filtered(then, wanted);
                let otherwise = filtered(otherwise, wanted);
                match (then.is_empty(), otherwise.is_empty()) {
                    (true, true) => {}
                    (true, false) => kept.push(Statement::If(opposite(condition), otherwise, then)),
                    (false, _) => kept.push(Statement::If(condition.clone(), then, otherwise)),
                }
            }
        }
    }
    kept
}

/// Drops the assignments of a register to itself that come before any other: a `reg` holds by nature.
pub fn drop_holds(statements: &mut Vec<Statement>) {
    let mut assigned = HashSet::new();
    statements.retain(|statement| {
        let is_hold = match statement {
            Statement::Assign(target, value) => {
                let register = target.strip_suffix("$d");
                let is_own = |name: &String| name.strip_suffix("$q") == register;
                matches!(&value.form, Form::Name(name) if is_own(name))
                    && !assigned.contains(target)
            }
            Statement::If(..) => false,
        };
        if !is_hold {
            targets(statement, &mut assigned);
        }
        !is_hold
    });
}

fn targets(statement: &Statement, found: &mut HashSet<String>) {
    match statement {
        Statement::Assign(target, _) => {
            found.insert(target.clone());
        }
        Statement::If(_, then, otherwise) => {
            then.iter()
                .chain(otherwise)
                .for_each(|statement| targets(statement, found));
        }
    }
}

/// Drops assignments that a later one replaces in any case.
pub fn drop_replaced(statements: &mut Vec<Statement>) {
    let mut last = HashMap::new();
    for (place, statement) in statements.iter().enumerate() {
        if let Statement::Assign(target, _) = statement {
            last.insert(target.clone(), place);
        }
    }
    let mut place = 0;
    statements.retain(|statement| {
        place += 1;
        !matches!(statement, Statement::Assign(target, _) if last[target] >= place)
    });
}

fn opposite(condition: &Expression) -> Expression {
    Expression {
        form: Form::Unary("~", Box::new(condition.clone())),
        of: condition.of,
    }
}

/// Works out the value every target has in the end; a later assignment replaces an earlier one.
pub fn execute(
    statements: &[Statement],
    values: &mut BTreeMap<String, Expression>,
) -> Result<(), EmitError> {
    for statement in statements {
        match statement {
            Statement::Assign(target, value) => {
                values.insert(target.clone(), value.clone());
            }
            Statement::If(condition, then, otherwise) => {
                let mut then_values = values.clone();
                execute(then, &mut then_values)?;
                let mut other_values = values.clone();
                execute(otherwise, &mut other_values)?;
                *values = joined(condition, then_values, other_values)?;
            }
        }
    }
    Ok(())
}

/// Refuses a local signal that is assigned after it was read: the reader in the simulation saw a value that no wire has.
pub fn check_order(
    statements: &[Statement],
    lowered: &Lowered,
    seen: &mut HashSet<String>,
) -> Result<(), EmitError> {
    for statement in statements {
        match statement {
            Statement::Assign(target, value) => {
                read(value, &mut |name, _| {
                    seen.insert(name.to_owned());
                });
                if lowered.names[target].role == Role::Local && seen.contains(target) {
                    return Err(EmitError::block(target, "is assigned after it was read"));
                }
            }
            Statement::If(condition, then, otherwise) => {
                read(condition, &mut |name, _| {
                    seen.insert(name.to_owned());
                });
                check_order(then, lowered, seen)?;
                check_order(otherwise, lowered, seen)?;
            }
        }
    }
    Ok(())
}

fn joined(
    condition: &Expression,
    then: BTreeMap<String, Expression>,
    mut otherwise: BTreeMap<String, Expression>,
) -> Result<BTreeMap<String, Expression>, EmitError> {
    let mut values = BTreeMap::new();
    for (target, value) in then {
        let other = otherwise
            .remove(&target)
            .ok_or_else(|| EmitError::block(&target, "is a latch"))?;
        let value = if value == other {
            value
        } else {
            let of = value.of;
            let form = Form::Choice(
                Box::new(condition.clone()),
                Box::new(value),
                Box::new(other),
            );
            Expression { form, of }
        };
        values.insert(target, value);
    }
    match otherwise.into_keys().next() {
        Some(target) => Err(EmitError::block(&target, "is a latch")),
        None => Ok(values),
    }
}

/// Calls `found` with every name that a value reads, and ones at the bits that it reads.
pub fn read(value: &Expression, found: &mut dyn FnMut(&str, u64)) {
    match &value.form {
        Form::Name(name) | Form::Extended(name, _) => found(name, u64::MAX),
        Form::Bits { of, high, low } => found(of, ones(high - low + 1) << low),
        Form::Literal(_) => {}
        Form::Unary(_, operand) => read(operand, found),
        Form::Binary(left, _, right) => {
            read(left, found);
            read(right, found);
        }
        Form::Choice(condition, then, otherwise) => {
            read(condition, found);
            read(then, found);
            read(otherwise, found);
        }
    }
}

/// A word with ones in its low bits, 1 to 64 of them.
pub fn ones(count: usize) -> u64 {
    u64::MAX >> (64 - count)
}

pub fn read_statements(statements: &[Statement], found: &mut dyn FnMut(&str, u64)) {
    for statement in statements {
        match statement {
            Statement::Assign(_, value) => read(value, found),
            Statement::If(condition, then, otherwise) => {
                read(condition, found);
                read_statements(then, found);
                read_statements(otherwise, found);
            }
        }
    }
}
