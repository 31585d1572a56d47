//! The functions of a design.

use crate::body::Body;
use crate::layout::Layout;
use crate::program::Given;
use cranelift_codegen::Context;
use cranelift_codegen::ir::{AbiParam, InstBuilder, Value};
use cranelift_codegen::settings::{self, Configurable};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{FuncId, Module as _, default_libcall_names};
use imogene_hdl::{Design, Module};
use std::collections::HashMap;
use std::mem::{ManuallyDrop, transmute};
use std::rc::Rc;

type Clock = unsafe extern "C" fn(*mut u64);
type Read = unsafe extern "C" fn(*const u64, *mut u64);

/// Machine code of a design: a function for its clock, one for what its outputs and one for what its points give.
///
/// Callers hand over slices of the sizes that the code was made for.
pub(crate) struct Code {
    clock: Clock,
    read: [Read; 2],
    /// Where the functions lie.
    memory: ManuallyDrop<JITModule>,
}

// SAFETY: the code is complete before it is shared, and its functions touch nothing but the words handed to them.
unsafe impl Send for Code {}
// SAFETY: as above.
unsafe impl Sync for Code {}

/// What is needed to make functions.
struct Functions {
    code: JITModule,
    context: Context,
    builder: FunctionBuilderContext,
    of_modules: HashMap<*const Module, FuncId>,
}

impl Code {
    pub(crate) fn of(design: &Design, layout: &Layout, read: [&[String]; 2]) -> Code {
        let mut functions = Functions::new();
        let modules = design.top.all();
        for module in modules
            .iter()
            .filter(|module| layout.block(module).is_called)
        {
            functions.add_clock(module, layout);
        }
        let clock = functions.of_modules[&Rc::as_ptr(&design.top)];
        let read = read.map(|paths| functions.add_read(&design.top, layout, paths));
        let mut code = functions.code;
        code.finalize_definitions().expect("memory for code");
        let [clock, outputs, points] =
            [clock, read[0], read[1]].map(|id| code.get_finalized_function(id));
        // SAFETY: the functions were made with these signatures.
        let read = [outputs, points].map(|read| unsafe { transmute::<*const u8, Read>(read) });
        Code {
            // SAFETY: as above.
            clock: unsafe { transmute::<*const u8, Clock>(clock) },
            read,
            memory: ManuallyDrop::new(code),
        }
    }

    /// The rising edge.
    pub(crate) fn clock(&self, words: &mut [u64]) {
        // SAFETY: the function reads and writes this block alone, whose size is that of the layout it was made for.
        unsafe { (self.clock)(words.as_mut_ptr()) }
    }

    /// What outputs or points give.
    pub(crate) fn read(&self, which: Given, words: &[u64], given: &mut [u64]) {
        // SAFETY: the function reads this block and writes as many words as it reads.
        unsafe { (self.read[which as usize])(words.as_ptr(), given.as_mut_ptr()) }
    }
}

impl Drop for Code {
    fn drop(&mut self) {
        // SAFETY: the functions go with it, and the memory is taken once.
        unsafe { ManuallyDrop::take(&mut self.memory).free_memory() }
    }
}

impl Functions {
    fn new() -> Functions {
        let mut flags = settings::builder();
        for (name, value) in [("opt_level", "speed"), ("enable_verifier", "false")] {
            flags
                .set(name, value)
                .expect("a setting of the code generator");
        }
        let target = cranelift_native::builder().expect("code is generated for this processor");
        let target = target.finish(settings::Flags::new(flags));
        let target = target.expect("settings of this processor");
        let code = JITModule::new(JITBuilder::with_isa(target, default_libcall_names()));
        Functions {
            context: code.make_context(),
            code,
            builder: FunctionBuilderContext::new(),
            of_modules: HashMap::new(),
        }
    }

    /// Adds the rising edge of a module; those that it calls are there.
    fn add_clock(&mut self, module: &Rc<Module>, layout: &Layout) {
        let of_modules = self.of_modules.clone();
        let id = self.add(1, |code, to, parameters| {
            let mut body = Body::new(to, parameters[0], layout, module);
            body.update(&mut |part, to| {
                code.declare_func_in_func(of_modules[&Rc::as_ptr(part)], to.func)
            });
            body.to
        });
        self.of_modules.insert(Rc::as_ptr(module), id);
    }

    /// Adds what reads the nets at these paths.
    fn add_read(&mut self, top: &Rc<Module>, layout: &Layout, paths: &[String]) -> FuncId {
        self.add(2, |_, to, parameters| {
            let mut body = Body::new(to, parameters[0], layout, top);
            for (index, path) in paths.iter().enumerate() {
                let place = body.find(path);
                let value = body.zeros(place);
                body.store(value, parameters[1], index);
            }
            body.to
        })
    }

    /// Adds a function of so many addresses.
    fn add(
        &mut self,
        parameters: usize,
        write: impl for<'a> FnOnce(&mut JITModule, FunctionBuilder<'a>, &[Value]) -> FunctionBuilder<'a>,
    ) -> FuncId {
        let Functions {
            code,
            context,
            builder,
            ..
        } = self;
        let address = AbiParam::new(code.target_config().pointer_type());
        context.func.signature = code.make_signature();
        context
            .func
            .signature
            .params
            .extend(vec![address; parameters]);
        let mut to = FunctionBuilder::new(&mut context.func, builder);
        let block = to.create_block();
        to.append_block_params_for_function_params(block);
        to.switch_to_block(block);
        to.seal_block(block);
        let parameters = to.block_params(block).to_vec();
        let mut to = write(code, to, &parameters);
        to.ins().return_(&[]);
        to.finalize(code.target_config());
        let signature = &context.func.signature;
        let id = code.declare_anonymous_function(signature);
        let id = id.expect("a function without a name");
        code.define_function(id, context)
            .expect("a function of known operations");
        code.clear_context(context);
        id
    }
}
