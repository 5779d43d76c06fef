/* The file ends within a function. */
int main(void)
{
    if (1) {
        return 0; // error: unexpected end of file
