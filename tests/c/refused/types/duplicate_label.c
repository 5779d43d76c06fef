/* The same label twice. */
int main(void)
{
here:
    if (0)
        goto here;
here: // error: label
    return 0;
}
