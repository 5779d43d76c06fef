/* Functions do not give arrays or functions; arrays do not hold functions; void has no value. */
int f(void)[3]; // error: function cannot return an array of type 'int[3]'
int g(void)(void); // error: function cannot return a function of type 'int (void)'
int h[2](void); // error: array of functions of type 'int (void)'
void v[3]; // error: array has incomplete element type 'void'
int i(void, int); // error: parameter has type 'void'

int main(void)
{
    return 0;
}
