/* Inline assembler cannot be translated for another machine. */
int main(void)
{
    __asm__("cli"); // error: assembly
    return 0;
}
