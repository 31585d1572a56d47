//! Choices in sums: the cells are evaluated before and after, as the models of Lattice and Yosys describe them.

use super::fold_module;
use proptest::prelude::*;
use serde_json::{Map, Value, json};
use std::collections::HashMap;

/// First nets of the inputs, of the sums, of the carries, and of what tables give.
const INPUT: u64 = 2;
const SUM: u64 = 100;
const CARRY: u64 = 200;
const TABLE: u64 = 300;
/// Inputs of a module.
const INPUTS: usize = 10;

/// A table of four nets.
#[derive(Clone, Debug)]
struct Table {
    inputs: [Value; 4],
    entries: u16,
}

/// Nets of a bit.
fn bits(net: &Value) -> Value {
    json!([net])
}

fn directions(connections: &Map<String, Value>, outputs: &[&str]) -> Value {
    let of = |port: &String| {
        let is_output = outputs.contains(&port.as_str());
        let side = if is_output { "output" } else { "input" };
        (port.clone(), json!(side))
    };
    connections.keys().map(of).collect::<Map<_, _>>().into()
}

fn cell(kind: &str, parameters: Value, connections: Map<String, Value>, outputs: &[&str]) -> Value {
    json!({
        "type": kind, "parameters": parameters, "port_directions": directions(&connections, outputs),
        "connections": connections,
    })
}

fn table(Table { inputs, entries }: &Table, output: u64) -> Value {
    let ports = ["A", "B", "C", "D"].into_iter().zip(inputs);
    let ports = ports.map(|(port, net)| (port.to_owned(), bits(net)));
    let mut connections: Map<_, _> = ports.collect();
    connections.insert("Z".into(), json!([output]));
    let parameters = json!({ "INIT": format!("{entries:016b}") });
    cell("LUT4", parameters, connections, &["Z"])
}

/// The cells of a sum of two words, least bit first, the second one inverted or not; its bits are the nets from `SUM`.
fn sum(terms: &[[Value; 2]], inverted: bool) -> Map<String, Value> {
    sum_at(0, terms, inverted)
}

/// The same, so many nets further on.
fn sum_at(first: u64, terms: &[[Value; 2]], inverted: bool) -> Map<String, Value> {
    let constant = if inverted { "1" } else { "0" };
    let one = |(index, pair): (usize, &[[Value; 2]])| {
        let mut connections = Map::new();
        let carry = |index: usize| json!([CARRY + first + index as u64]);
        let into = match index {
            0 => json!([constant]),
            _ => carry(index),
        };
        connections.insert("CIN".into(), into);
        connections.insert("COUT".into(), carry(index + 1));
        for (half, [a, b]) in pair.iter().enumerate() {
            let out = json!(SUM + first + 2 * index as u64 + half as u64);
            let nets = [a, b, &json!(constant), &json!("1"), &out];
            for (port, net) in "ABCDS".chars().zip(nets) {
                connections.insert(format!("{port}{half}"), bits(net));
            }
        }
        let parameters = json!({
            "INIT0": "1001011010101010", "INIT1": "1001011010101010", "INJECT1_0": "NO", "INJECT1_1": "NO",
        });
        let outputs = ["S0", "S1", "COUT"];
        let sum = cell("CCU2C", parameters, connections, &outputs);
        (format!("sum_{first}_{index}"), sum)
    };
    terms.chunks_exact(2).enumerate().map(one).collect()
}

fn module(cells: Map<String, Value>, outputs: &[u64]) -> Value {
    json!({ "ports": { "out": { "direction": "output", "bits": outputs } }, "cells": cells })
}

/// The values of nets, by the functions of the cells.
struct Evaluation<'a> {
    cells: &'a Map<String, Value>,
    writers: HashMap<u64, (&'a str, &'a str)>,
    inputs: u16,
}

impl<'a> Evaluation<'a> {
    fn of(module: &'a Value, inputs: u16) -> Evaluation<'a> {
        let cells = module["cells"].as_object().expect("cells");
        let mut writers = HashMap::new();
        for (name, cell) in cells {
            for (port, nets) in cell["connections"].as_object().expect("ports") {
                if cell["port_directions"][port] == "output" {
                    let net = nets[0].as_u64().expect("a net");
                    let before = writers.insert(net, (name.as_str(), port.as_str()));
                    assert!(before.is_none(), "{net}");
                }
            }
        }
        Evaluation {
            cells,
            writers,
            inputs,
        }
    }

    fn net(&self, net: &Value) -> bool {
        let Some(wire) = net.as_u64() else {
            return net == "1";
        };
        match self.writers.get(&wire) {
            None => self.inputs >> (wire - INPUT) & 1 == 1,
            Some((cell, "Z")) => self.entry(&self.cells[*cell], "INIT", ["A", "B", "C", "D"]),
            Some((cell, "S0")) => self.half(cell, 0) != self.port(cell, "CIN"),
            Some((cell, "S1")) => self.half(cell, 1) != self.carry(cell, 0),
            Some((cell, _)) => self.carry(cell, 1),
        }
    }

    fn port(&self, cell: &str, port: &str) -> bool {
        self.net(&self.cells[cell]["connections"][port][0])
    }

    fn entry(&self, cell: &Value, entries: &str, inputs: [&str; 4]) -> bool {
        let text = cell["parameters"][entries].as_str().expect("entries");
        let nets = inputs.map(|input| self.net(&cell["connections"][input][0]));
        let nets = nets.into_iter().rev();
        let index = nets.fold(0, |index, bit| 2 * index + usize::from(bit));
        text.as_bytes()[15 - index] == b'1'
    }

    /// The table of four inputs of half a cell.
    fn half(&self, cell: &str, half: usize) -> bool {
        let inputs = ["A", "B", "C", "D"].map(|input| format!("{input}{half}"));
        let [a, b, c, d] = &inputs;
        self.entry(&self.cells[cell], &format!("INIT{half}"), [a, b, c, d])
    }

    /// The carry out of half a cell: the one into it where the table is 1, else the table of A and B, which is the
    /// last four digits of the entries.
    fn carry(&self, cell: &str, half: usize) -> bool {
        if self.half(cell, half) {
            return match half {
                0 => self.port(cell, "CIN"),
                _ => self.carry(cell, 0),
            };
        }
        let text = &self.cells[cell]["parameters"][format!("INIT{half}")];
        let text = text.as_str().expect("entries");
        let [a, b] = ["A", "B"].map(|input| self.port(cell, &format!("{input}{half}")));
        text.as_bytes()[15 - usize::from(a) - 2 * usize::from(b)] == b'1'
    }

    fn outputs(&self, module: &Value) -> Vec<bool> {
        let nets = module["ports"]["out"]["bits"].as_array().expect("outputs");
        nets.iter().map(|net| self.net(net)).collect()
    }
}

fn is_same(before: &Value, after: &Value) -> Result<(), TestCaseError> {
    for inputs in 0..1 << INPUTS {
        let value = |module| Evaluation::of(module, inputs).outputs(module);
        let (one, other) = (value(before), value(after));
        prop_assert_eq!(one, other, "inputs {:b} of {}", inputs, before);
    }
    Ok(())
}

/// An input or a constant.
fn net() -> impl Strategy<Value = Value> {
    prop_oneof![
        8 => (INPUT..INPUT + INPUTS as u64).prop_map(|net| json!(net)),
        1 => Just(json!("0")),
        1 => Just(json!("1")),
    ]
}

/// A net that gives `to` where `steer` is 1, and else another one, or the other way round.
fn choice(steer: &Value, to: Value, sum: Value, turned: bool) -> Table {
    let inputs = [steer.clone(), to, sum, json!("0")];
    let entries = if turned { 0b1101_1000 } else { 0b1110_0100 };
    Table { inputs, entries }
}

/// A table of any function of a net and three others.
fn any_table(bit: Value) -> impl Strategy<Value = Table> {
    let others = [net(), net(), net()];
    (others, any::<u16>()).prop_map(move |([a, b, c], entries)| Table {
        inputs: [a, b, bit.clone(), c],
        entries,
    })
}

/// What stands behind a bit of a sum: nothing that reads it, a port, a choice, any table.
fn behind(place: usize) -> impl Strategy<Value = (bool, Option<Table>)> {
    let bit = json!(SUM + place as u64);
    let steer = json!(INPUT);
    let turned = bit.clone();
    prop_oneof![
        1 => Just((false, None)),
        1 => Just((true, None)),
        12 => net().prop_map(move |to| (true, Some(choice(&steer, to, bit.clone(), true)))),
        2 => any_table(turned).prop_map(|table| (true, Some(table))),
    ]
}

/// A term: a net, or what any table of inputs gives.
fn term() -> impl Strategy<Value = Result<Value, Box<Table>>> {
    prop_oneof![
        net().prop_map(Ok),
        net()
            .prop_flat_map(any_table)
            .prop_map(|made| Err(made.into())),
        (net(), net(), net(), any::<bool>())
            .prop_map(|(steer, to, other, turned)| Err(choice(&steer, to, other, turned).into())),
    ]
}

proptest! {
    #[test]
    fn any_sum_with_tables_around_it_stays_what_it_is(
        terms in prop::collection::vec([term(), term()], 4),
        behind in [behind(0), behind(1), behind(2), behind(3)],
        inverted in prop::bool::weighted(0.3),
    ) {
        let mut cells = Map::new();
        let mut outputs = vec![];
        let mut next = TABLE;
        let mut add = |cells: &mut Map<String, Value>, made: &Table| {
            next += 1;
            cells.insert(format!("table_{next}"), table(made, next));
            next
        };
        let mut term = |term: Result<Value, Box<Table>>| term.unwrap_or_else(|made| json!(add(&mut cells, &made)));
        let terms: Vec<[Value; 2]> = terms.into_iter().map(|pair| pair.map(&mut term)).collect();
        for (place, (is_read, made)) in behind.iter().enumerate() {
            let out = made.as_ref().map_or(SUM + place as u64, |made| add(&mut cells, made));
            outputs.extend(is_read.then_some(out));
        }
        cells.extend(sum(&terms, inverted));
        let before = module(cells, &outputs);
        let mut after = before.clone();
        let folded = fold_module(&mut after);
        let fewer = before["cells"].as_object().map_or(0, Map::len) - after["cells"].as_object().map_or(0, Map::len);
        prop_assert_eq!(folded.tables, fewer as u64);
        is_same(&before, &after)?;
    }
}

/// Four bits of the inputs from 2 and from 6.
fn plain() -> Vec<[Value; 2]> {
    let pair = |bit| [json!(INPUT + bit), json!(INPUT + 4 + bit)];
    (0..4).map(pair).collect()
}

/// A sum of four bits, and tables: how many of these the folded one has not.
fn without(inverted: bool, tables: &[Table], more: &[u64]) -> u64 {
    let mut cells = sum(&plain(), inverted);
    let mut outputs = more.to_vec();
    for (net, made) in (TABLE..).zip(tables) {
        cells.insert(format!("table_{net}"), table(made, net));
        outputs.push(net);
    }
    let before = module(cells, &outputs);
    let mut after = before.clone();
    let folded = fold_module(&mut after).tables;
    is_same(&before, &after).expect("the same function");
    folded
}

/// The choices behind four bits: a constant or the sum, by the input 10.
fn choices() -> Vec<Table> {
    let bit = |bit| choice(&json!(INPUT + 8), json!("1"), json!(SUM + bit), true);
    (0..4).map(bit).collect()
}

#[test]
fn a_word_that_is_loaded_or_a_sum_takes_one_cell_for_a_bit() {
    assert_eq!(without(false, &choices(), &[]), 4);
}

#[test]
fn a_choice_stays_where_the_sum_is_read_beside_it_or_another_net_steers() {
    let mut other = choices();
    other[2] = choice(&json!(INPUT + 9), json!("1"), json!(SUM + 2), true);
    assert_eq!(without(false, &other, &[]), 0, "another net");
    assert_eq!(without(false, &choices(), &[SUM + 1]), 0, "read beside it");
    let carried = without(false, &choices(), &[CARRY + 2]);
    assert_eq!(carried, 0, "last carry read");
    assert_eq!(without(true, &choices(), &[]), 0, "a difference");
}

#[test]
fn a_term_of_three_inputs_takes_no_cell() {
    let [steer, to, other] = [8, 0, 4].map(|place| json!(INPUT + place));
    let mut terms = plain();
    terms[1][1] = json!(TABLE);
    let made = choice(&steer, to, other, false);
    let mut cells = sum(&terms, false);
    cells.insert("table".into(), table(&made, TABLE));
    let before = module(cells, &[SUM, SUM + 1, SUM + 2, SUM + 3]);
    let mut after = before.clone();
    assert_eq!(fold_module(&mut after).tables, 1);
    is_same(&before, &after).expect("the same function");
}

#[test]
fn a_choice_between_two_sums_is_part_of_one() {
    let other = plain().into_iter().map(|[a, b]| [b, a]).collect::<Vec<_>>();
    let mut cells = sum(&plain(), false);
    cells.extend(sum_at(50, &other, false));
    let nets: Vec<u64> = (TABLE..TABLE + 4).collect();
    for (bit, net) in (0..).zip(&nets) {
        let [to, sum] = [SUM + 50 + bit, SUM + bit].map(|net| json!(net));
        let made = choice(&json!(INPUT + 8), to, sum, true);
        cells.insert(format!("table_{net}"), table(&made, *net));
    }
    let before = module(cells, &nets);
    let mut after = before.clone();
    assert_eq!(fold_module(&mut after).tables, 4);
    is_same(&before, &after).expect("the same function");
}
