/* Names for the linker that are none. */
int f(void) __asm__("two words");  // error: expected a string literal in 'asm'
//          ^
int g asm("");  // error: expected a string literal in 'asm'
int main(void) { return 0; }
