mod count;
mod duplication;
mod figures;
mod row;
mod scenes;
mod steps;
mod table;
mod work;
