/* Functions and objects that are declared and used through pointers, but not defined. */
extern int missing_function(int);
extern int missing_object[];

static int (*const table[])(int) = { missing_function }; // error: 'missing_function' is used, but not defined
static int *const pointer = missing_object; // error: 'missing_object' is used, but not defined

int main(void)
{
    return table[0](1) + *pointer;
}
