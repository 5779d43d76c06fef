/* A macro defined again must be the same; the paste of two tokens must be one. */
#define JOIN(a, b) a ## b
#define BAD a ## // error: '##' cannot be at either end of a macro's body
#define WORSE(a) #b // error: '#' is not followed by a parameter of the macro
#define 3x 1 // error: macro name must be an identifier, not '3x'
#define AGAIN(x, x) x // error: 'x' cannot be a parameter here

int main(void)
{
    return 0;
}
