//
// Direct calls of a loop for common arrays, at a fraction of the cost of NumPy's own dispatch.
#ifndef DUALCAY_DIRECT_H
#define DUALCAY_DIRECT_H

// Arguments of a call of a loop.
typedef struct {
    char *at[DUALCAY_OPERANDS];
    npy_intp steps[DUALCAY_OPERANDS * (1 + DUALCAY_AXES)]; // of batch axes, then of component axes
    npy_intp dims[NPY_MAXDIMS]; // of the result, the batch first
    int batch, components; // number of batch axes, number of component steps so far
} dualcay_call;

// Add an argument to a call. Return 0 if a direct call is impossible: the argument is no array of aligned float64, has
// another shape or batch, or has several batch axes and is not contiguous.
static int dualcay_take(dualcay_call *call, PyObject *given, int arguments, int i, int axes, const int *counts)
{
    PyArrayObject *array = (PyArrayObject *)given;
    const npy_intp *dims, *strides;
    npy_intp packed = sizeof(double); // step from value to value of a contiguous array
    int batch;
    if (!PyArray_CheckExact(given) || PyArray_TYPE(array) != NPY_DOUBLE || !PyArray_ISBEHAVED_RO(array)) {
        return 0;
    }
    dims = PyArray_DIMS(array), strides = PyArray_STRIDES(array), batch = PyArray_NDIM(array) - axes;
    if (batch < 0 || (batch > 1 && !PyArray_IS_C_CONTIGUOUS(array))) {
        return 0;
    }
    for (int axis = 0; axis < axes; ++axis) {
        if (dims[batch + axis] != counts[axis]) {
            return 0;
        }
        call->steps[arguments + 1 + call->components++] = strides[batch + axis];
        packed *= counts[axis];
    }
    if (batch && call->batch && batch != call->batch) {
        return 0;
    }
    for (int axis = 0; axis < batch; ++axis) {
        if (call->batch && dims[axis] != call->dims[axis]) {
            return 0;
        }
        call->dims[axis] = dims[axis];
    }
    call->batch = batch ? batch : call->batch;
    call->at[i] = PyArray_BYTES(array);
    // an axis of length 1 may have any stride, also in a contiguous array
    call->steps[i] = batch > 1 ? packed : batch ? strides[0] : 0;
    return 1;
}

// Create an array for the result and set its steps. Return NULL with an exception if memory is short.
static PyObject *dualcay_make(dualcay_call *call, int arguments, int axes, const int *counts)
{
    npy_intp step = sizeof(double);
    PyObject *made;
    for (int axis = axes - 1; axis >= 0; --axis) {
        call->dims[call->batch + axis] = counts[axis];
        call->steps[arguments + 1 + call->components + axis] = step;
        step *= counts[axis];
    }
    call->steps[arguments] = step;
    made = PyArray_SimpleNew(call->batch + axes, call->dims, NPY_DOUBLE);
    call->at[arguments] = made ? PyArray_BYTES((PyArrayObject *)made) : NULL;
    return made;
}

// Return the result of the loop with number ``self``, or None if the caller has to use another form: for other arrays,
// and where a result is not finite.
static PyObject *dualcay_direct(PyObject *self, PyObject *const *given, Py_ssize_t number)
{
    const int index = (int)PyLong_AsLong(self), arguments = rows[index].arguments;
    npy_intp count = 1;
    dualcay_call call;
    PyObject *made;
    NPY_BEGIN_THREADS_DEF;
    call.batch = call.components = 0;
    if (number != arguments) {
        Py_RETURN_NONE;
    }
    for (int i = 0; i < arguments; ++i) {
        if (!dualcay_take(&call, given[i], arguments, i, rows[index].operands[i].axes, rows[index].operands[i].counts)) {
            Py_RETURN_NONE;
        }
    }
    if (call.batch + DUALCAY_AXES > NPY_MAXDIMS) {
        Py_RETURN_NONE;
    }
    made = dualcay_make(&call, arguments, rows[index].operands[arguments].axes, rows[index].operands[arguments].counts);
    if (!made) {
        return NULL;
    }
    for (int axis = 0; axis < call.batch; ++axis) {
        count *= call.dims[axis];
    }
    feclearexcept(FE_INVALID);
    NPY_BEGIN_THREADS_THRESHOLDED(count);
    DUALCAY_LOOPS_OF(double)[index](call.at, &count, call.steps, NULL);
    NPY_END_THREADS;
    if (fetestexcept(FE_INVALID)) {
        feclearexcept(FE_INVALID);
        Py_DECREF(made);
        Py_RETURN_NONE;
    }
    return PyArray_Return((PyArrayObject *)made);
}

// Add the dictionary DIRECT of direct calls by name to a module. Return 0, or -1 with an exception.
static int dualcay_add_direct(PyObject *module)
{
    static PyMethodDef methods[DUALCAY_LOOPS];
    PyObject *ways = PyDict_New();
    int failed = !ways;
    for (int index = 0; !failed && index < DUALCAY_LOOPS; ++index) {
        const PyMethodDef method = {rows[index].name, (PyCFunction)(void (*)(void))dualcay_direct, METH_FASTCALL, NULL};
        PyObject *self = PyLong_FromLong(index), *way = NULL;
        methods[index] = method;
        way = self ? PyCFunction_New(&methods[index], self) : NULL;
        failed = !way || PyDict_SetItemString(ways, rows[index].name, way);
        Py_XDECREF(way);
        Py_XDECREF(self);
    }
    failed = failed || PyModule_AddObjectRef(module, "DIRECT", ways);
    Py_XDECREF(ways);
    return failed ? -1 : 0;
}

#endif
