/* Attributes that cannot be ignored without changing the program's behaviour. */
int f(void);
int g(void) __attribute__((ifunc("f")));  // error: attribute 'ifunc' is not supported
//                         ^
typedef float four __attribute__((vector_size(16)));  // error: attribute 'vector_size' is not supported
int h __attribute__(unused);  // error: expected '((' after '__attribute__'
int main(void) { return 0; }
