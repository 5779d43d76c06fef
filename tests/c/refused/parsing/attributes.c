/* Attributes that cannot be ignored without changing the program. */
int f(void);
int g(void) __attribute__((alias("f")));  // error: attribute 'alias' is not supported
//                         ^
typedef float four __attribute__((vector_size(16)));  // error: attribute 'vector_size' is not supported
int h __attribute__(unused);  // error: expected '((' after '__attribute__'
int main(void) { return 0; }
