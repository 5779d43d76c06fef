/* Names that several headers define, and that one of them is known for. */
int main(void)
{
    char *text = NULL; // error: include <stddef.h>
    size_t size = 0;   // error: include <stddef.h>
    text = text + size;
    return 0;
}
